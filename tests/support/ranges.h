// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Whole drives are chaotic in their digits: their tests print each range and whether the value is
// in it. The digits themselves go to the file `digits` in the run's directory.

#include <chaindrive/commands.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace test
{
/// While it lives nothing that is written to the standard error is seen.
class Silence
{
public:
  Silence() : error_(dup(STDERR_FILENO))
  {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }
  Silence(const Silence &)            = delete;
  Silence &operator=(const Silence &) = delete;
  ~Silence()
  {
    dup2(error_, STDERR_FILENO);
    close(error_);
  }

private:
  int error_;
};

/// Runs @p file, relative to the repository, with the overrides, and returns its summary. What the
/// checks of the drive say goes to the log only.
inline nlohmann::json run(const std::string &file, const std::vector<std::string> &overrides = {})
{
  chaindrive::CommandLine command_line;
  command_line.parameter_file   = std::string(SOURCE_DIR) + "/../../" + file;
  command_line.overrides        = overrides;
  command_line.output_directory = "results";
  command_line.quiet            = true;
  const Silence silence;
  chaindrive::run_command(command_line, MPI_COMM_SELF);
  return nlohmann::json::parse(std::ifstream("results/summary.json"));
}

/// Prints whether @p value lies in [low, high].
inline void range(const std::string &what, const double value, const double low, const double high)
{
  std::ofstream("digits", std::ios::app) << what << " = " << std::setprecision(8) << value << '\n';
  std::cout << what << " in [" << low << ", " << high
            << "]: " << (value >= low && value <= high ? "yes" : "NO") << std::endl;
}

/// The figures that any valid model of the paper's drive must give.
inline void paper_ranges(const nlohmann::json &s, const double least_angle, const double least_work)
{
  range("pitch time (ms)", 1e3 * s["pitch_time_mean"].get<double>(), 3.36, 3.62);
  range("driven speed (rad/s)", s["driven_speed_mean"], 42.9, 43.4);
  range("tight-span speed (m/s)", s["span_speed_mean"], 4.54, 4.62);
  range("tight less slack tension (N)",
        s["tight_tension_mean"].get<double>() - s["slack_tension_mean"].get<double>(),
        1340.,
        1460.);
  range("driver torque (N m)", s["driver_torque_mean"], 50.5, 56.);
  range("resisting work (J)", s["resisting_work"], least_work, 175.7);
  range("drive work (J)", s["drive_work"], 192., 206.);
  range("driven angle at the end (rad)", s["driven_angle_end"], least_angle, 1.187);
}

/// Engagements of the driver: peak over v sqrt(k m) and impulse, of all complete ones that begin in
/// the window. @p k [N/m] and @p m [kg] are the roller-tooth stiffness and the mass of an impact.
inline void engagement_ranges(const nlohmann::json &s, const double k, const double m)
{
  double       peak = 0., least = 1e9, most = 0.;
  unsigned int n = 0;
  for (const auto &e : s["engagements"])
    if (e["sprocket"] == "driver" && e["complete"] && e["time"] >= s["window"]["start"])
      {
        const double scaled =
            e["peak_force"].get<double>() / (e["normal_speed"].get<double>() * std::sqrt(k * m));
        peak += scaled;
        least = std::min(least, e["impulse"].get<double>());
        most  = std::max(most, e["impulse"].get<double>());
        ++n;
      }
  range("complete engagements of the driver", n, 4, 6);
  range("mean peak force / (v sqrt(k m))", peak / n, 0.75, 1.25);
  range("least impulse of the first 0.3 ms (N s)", least, 0.025, 0.057);
  range("largest impulse of the first 0.3 ms (N s)", most, 0.025, 0.057);
}
} // namespace test
