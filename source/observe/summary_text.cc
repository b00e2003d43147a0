// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/summary.h>

#include <iomanip>

namespace chaindrive::observe
{
void print_summary(std::ostream &out, const files::Json &summary)
{
  const auto line =
      [&](const char *text, const char *member, const char *unit, const double scale = 1.) {
        if (!summary.contains(member))
          return; // not asked for
        out << "  " << std::left << std::setw(34) << text << std::right << std::setw(12);
        if (summary[member].is_number())
          out << std::setprecision(5) << scale * summary[member].get<double>();
        else
          out << "-";
        out << ' ' << unit << '\n';
      };
  const files::Json &window = summary["window"];
  if (window["start"].is_number())
    out << "Means from " << window["start"].get<double>() * 1e3 << " ms to "
        << window["end"].get<double>() * 1e3 << " ms"
        << (window["settled"].is_boolean() ? ", after the drive had settled\n" : "\n");
  else
    out << "No means: the drive has not settled\n";
  line("driven speed", "driven_speed_mean", "rad/s");
  line("tight-span speed", "span_speed_mean", "m/s");
  line("pitch time", "pitch_time_mean", "ms", 1e3);
  line("tight tension", "tight_tension_mean", "N");
  line("slack tension", "slack_tension_mean", "N");
  line("driver torque", "driver_torque_mean", "N m");
  out << "Whole run\n";
  line("largest tight tension in 10 ms", "tight_tension_max_start", "N");
  line("driven angle at the end", "driven_angle_end", "rad");
  line("drive work", "drive_work", "J");
  line("resisting work", "resisting_work", "J");
  line("largest energy imbalance", "energy_imbalance_max", "of the energy turned over");

  if (!summary.contains("engagements"))
    return;
  unsigned int n = 0;
  for (const files::Json &engagement : summary["engagements"])
    n += engagement["complete"].get<bool>() ? 1 : 0;
  out << "  " << n << " complete engagements in summary.json\n";
}
} // namespace chaindrive::observe
