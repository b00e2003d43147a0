// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/summary.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <string>
#include <vector>

namespace chaindrive::observe
{
namespace
{
constexpr double degrees = 180. / dealii::numbers::PI; // in a radian

/// A signal of `statistics` as the log has it.
struct Row
{
  std::string text, member, unit;
  double      scale = 1.;
};

const std::vector<Row> rows = {{"driven speed", "driven_speed", "rad/s"},
                               {"driver torque", "driver_torque", "N m"},
                               {"tight-span speed", "span_speed", "m/s"},
                               {"tight tension", "tight_tension", "N"},
                               {"slack tension", "slack_tension", "N"},
                               {"tight-span offset", "tight_offset", "mm", 1e3},
                               {"slack-span offset", "slack_offset", "mm", 1e3},
                               {"driver shaft load", "driver_load", "N"},
                               {"its direction", "driver_load_direction", "deg", degrees},
                               {"driven shaft load", "driven_load", "N"},
                               {"its direction", "driven_load_direction", "deg", degrees}};

void number(std::ostream      &out,
            const files::Json &value,
            const double       scale  = 1.,
            const unsigned int digits = 5,
            const unsigned int width  = 12)
{
  out << std::setw(width);
  if (value.is_number() && std::isfinite(value.get<double>()))
    out << std::setprecision(digits) << scale * value.get<double>();
  else
    out << "-";
}

/// Those of all sprockets that are no driver and not called driven.
std::vector<Row> rows_of_others(const files::Json &statistics)
{
  std::vector<Row> others;
  for (const auto &[member, found] : statistics.items())
    for (const Row &kind : {Row{": tension", "_tension", "N"},
                            Row{" speed", "_speed", "rad/s"},
                            Row{" shaft load", "_load", "N"},
                            Row{": its direction", "_load_direction", "deg", degrees}})
      if (const std::size_t end = member.rfind(kind.member);
          end != std::string::npos && end + kind.member.size() == member.size() &&
          std::none_of(rows.begin(), rows.end(), [&member = member](const Row &row) {
            return row.member == member;
          }))
        others.push_back({member.substr(0, end) + kind.text, member, kind.unit, kind.scale});
  return others;
}

void print_statistics(std::ostream &out, const files::Json &statistics)
{
  bool             headed = false;
  std::vector<Row> all    = rows;
  for (const Row &row : rows_of_others(statistics))
    all.push_back(row);
  for (const Row &row : all)
    {
      if (!statistics.contains(row.member))
        continue; // not asked for
      if (!headed)
        out << "  " << std::left << std::setw(18) << "in the window" << std::right << std::setw(12)
            << "mean" << std::setw(11) << "95 % +-" << std::setw(11) << "deviation" << std::setw(11)
            << "least" << std::setw(11) << "largest"
            << "   harmonics of tooth frequency\n";
      headed                   = true;
      const files::Json &found = statistics[row.member];
      out << "  " << std::left << std::setw(18) << row.text << std::right;
      number(out, found["mean"], row.scale);
      number(out, found["uncertainty"], row.scale, 3, 11);
      for (const char *name : {"deviation", "least", "largest"})
        number(out, found[name], row.scale, 4, 11);
      for (const files::Json &amplitude : found["harmonics"])
        number(out, amplitude, row.scale, 3, 10);
      out << ' ' << row.unit << '\n';
    }
  if (headed && statistics["tooth_periods"].is_number())
    out << "  harmonics over " << statistics["tooth_periods"] << " whole tooth periods\n";
}

std::string judged_pitches(const files::Json &window)
{
  return to_text(window["judged_pitches"].get<double>()) + " pitch times";
}

/// Of a window that was given: whether the drive had settled there. One that waited says so itself.
void print_settled(std::ostream &out, const files::Json &statistics, const files::Json &window)
{
  if (!statistics.contains("settled") || window["settled"].is_boolean())
    return;
  const std::string judged = judged_pitches(window);
  if (statistics["settled"].is_boolean())
    out << "  The drive had " << (statistics["settled"].get<bool>() ? "" : "not ")
        << "settled in the last " << judged << " of the window.\n";
  else
    out << "  Whether the drive had settled is judged over " << judged
        << ": the window is shorter.\n";
}

void print_impacts(std::ostream &out, const files::Json &impacts)
{
  for (const auto &[sprocket, found] : impacts.items())
    {
      if (found["number"] == 0)
        continue;
      out << "  impacts on the " << std::left << std::setw(7) << sprocket << std::right
          << std::setw(6) << found["number"].get<unsigned int>() << ", peak force ";
      number(out, found["peak_force"]["mean"], 1., 4, 0);
      out << " N (95 % +- ";
      number(out, found["peak_force"]["uncertainty"], 1., 4, 0);
      out << ", largest ";
      number(out, found["peak_force"]["largest"], 1., 4, 0);
      out << "), impulse ";
      number(out, found["impulse"]["mean"], 1., 3, 0);
      out << " N s (+- ";
      number(out, found["impulse"]["uncertainty"], 1., 2, 0);
      out << "), normal speed ";
      number(out, found["normal_speed"]["mean"], 1., 3, 0);
      out << " m/s (+- ";
      number(out, found["normal_speed"]["uncertainty"], 1., 2, 0);
      out << ")\n";
    }
}

void print_losses(std::ostream &out, const files::Json &summary)
{
  const files::Json &energy = summary["window_energy"];
  if (!energy["lost"].is_number())
    return; // nothing fell into the window
  out << "  lost ";
  number(out, energy["lost"], 1., 4, 0);
  out << " J (95 % +- ";
  number(out, energy["lost_uncertainty"], 1., 2, 0);
  out << ") of ";
  number(out, energy["drive_work"], 1., 4, 0);
  out << " J, and ";
  number(out, energy["stored"], 1., 3, 0);
  out << " J added to what is stored; efficiency ";
  number(out, summary["efficiency"], 1., 5, 0);
  out << " (95 % +- ";
  number(out, summary["efficiency_uncertainty"], 1., 2, 0);
  out << ")\n";
  for (const auto &[name, loss] : summary["losses"].items())
    {
      out << "  " << std::left << std::setw(34) << "loss in " + name << std::right;
      number(out, loss["power"]);
      out << " W (95 % +- ";
      number(out, loss["uncertainty"], 1., 2, 0);
      out << ")\n";
    }
}
} // namespace

void print_summary(std::ostream &out, const files::Json &summary)
{
  const auto line =
      [&](const char *text, const char *member, const char *unit, const double scale = 1.) {
        if (!summary.contains(member))
          return; // not asked for
        out << "  " << std::left << std::setw(34) << text << std::right;
        number(out, summary[member], scale);
        out << ' ' << unit << '\n';
      };
  const files::Json &window = summary["window"];
  if (window["start"].is_number())
    out << "Means from " << window["start"].get<double>() * 1e3 << " ms to "
        << window["end"].get<double>() * 1e3 << " ms"
        << (window["settled"].is_boolean() ?
                ", after the drive had settled over " + judged_pitches(window) :
                "")
        << (window.value("valid", files::Json(true)) == false ?
                ": NOT VALID, see the events in the window\n" :
                "\n");
  else
    out << "No means: the drive has not settled\n";
  if (summary.contains("pitch_time_mean"))
    {
      out << "  " << std::left << std::setw(34) << "pitch time" << std::right;
      number(out, summary["pitch_time_mean"], 1e3);
      out << " ms (95 % +- ";
      number(out, summary["pitch_time_uncertainty"], 1e3, 2, 0);
      out << ")\n";
    }
  if (summary.contains("statistics"))
    {
      print_statistics(out, summary["statistics"]);
      print_settled(out, summary["statistics"], window);
    }
  if (summary.contains("impacts"))
    print_impacts(out, summary["impacts"]);
  if (summary.contains("losses"))
    print_losses(out, summary);
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
