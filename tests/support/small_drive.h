// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "ranges.h"
#include "table.h"

#include <cmath>
#include <string>
#include <vector>

namespace test
{
/// Overrides that make a small full model of prm/paper/layered-auto.prm: 22 links between two
/// sprockets of 9 teeth.
inline const std::vector<std::string> small_full_drive = {
    "Model/Fidelity=full",
    "Mesh/Refinement=1",
    "Time/Time step in us=auto",
    "Drive/Number of links=22",
    "Drive/Driver teeth=9",
    "Drive/Driven teeth=9",
    "Drive/Sprockets/Driver outside diameter in mm=auto",
    "Drive/Sprockets/Driven outside diameter in mm=auto",
    "Drive/Sprockets/Driver hub diameter in mm=auto",
    "Drive/Sprockets/Driver bore in mm=auto",
    "Drive/Sprockets/Driven hub diameter in mm=auto",
    "Drive/Sprockets/Driven bore in mm=auto",
    "Drive/Layout/Centre distance from=slack",
    "Drive/Layout/Slack in mm=0.1",
    "Model/Driven inertia in kg m2=1e-4",
    "Loads/Resisting torque in N m=20",
    "Loads/Torque ramp angle in rad=0.01"};

/// That drive with @p more overrides.
inline std::vector<std::string>
small_full_drive_with(const std::vector<std::string> &more_overrides)
{
  std::vector<std::string> overrides = small_full_drive;
  overrides.insert(overrides.end(), more_overrides.begin(), more_overrides.end());
  return overrides;
}
/// Runs that drive from rest to full speed within 0.5 ms, and on to 1.5 ms, with @p more overrides.
/// Energy must close, the driver turn as prescribed and the chain pull the load round.
inline nlohmann::json start_small_full_drive(std::vector<std::string> more_overrides = {})
{
  more_overrides.insert(more_overrides.end(),
                        {"Loads/Ramp time in ms=0.5",
                         "Time/End time in ms=1.5",
                         "Output/Window start in ms=1",
                         "Output/CSV=true",
                         "Output/Field interval in ms=1"});
  const nlohmann::json s = run("prm/paper/layered-auto.prm", small_full_drive_with(more_overrides));
  const double         angle  = s["driven_angle_end"];
  const double         turned = 120.74 * (1.5e-3 - 0.25e-3); // rad: the ramp costs half its time
  range("energy imbalance / energy turned over", s["energy_imbalance_max"], 0., 1e-3);
  range("driven angle over driver's", angle / turned, 0.75, 1.);
  range("resisting work over torque times angle",
        s["resisting_work"].get<double>() / (20. * (angle - 0.5 * 0.01)),
        0.99,
        1.01);
  return s;
}

/// Energy of the elastic bodies of that drive over the energy that pulls their links, the sum of
/// T^2 / 2k with k = 115 kN/mm per pitch (test contact/pull, at 1 kN), from the histories of the
/// run, while the tension of the start is there. Rollers that are pressed, sprockets and pins that
/// bend have some part in it.
inline double strain_over_pull()
{
  const Table energy("results/histories_energy.csv"), links("results/histories_links.csv"),
      plates("results/histories_plates.csv");
  const std::vector<double> &time   = energy["time"];
  double                     strain = 0., pull = 0.;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (time[i] > 0.4e-3 && time[i] < 0.8e-3)
      {
        strain += energy["strain"][i];
        if (energy.has("hourglass")) // reduced bodies have none
          strain += energy["hourglass"][i];
        for (unsigned int k = 0; k < 22; ++k)
          if (const std::string name = std::to_string(k);
              !std::isnan(plates["axial_stress " + name][i])) // an elastic link
            pull += std::pow(links["tension " + name][i], 2) / (2. * 115e6);
      }
  return strain / pull;
}
} // namespace test
