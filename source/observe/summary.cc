// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/summary.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace chaindrive::observe
{
namespace
{
/// What a reader looks for first, the machine, and the longest list.
constexpr const char *first_members[] = {"events",
                                         "driven_angle_end",
                                         "driven_speed_mean",
                                         "span_speed_mean",
                                         "pitch_time_mean",
                                         "pitch_time_uncertainty",
                                         "tight_tension_mean",
                                         "slack_tension_mean",
                                         "tight_tension_max_start",
                                         "driver_torque_mean",
                                         "contacts_missed",
                                         "drive_work",
                                         "resisting_work",
                                         "efficiency",
                                         "efficiency_uncertainty",
                                         "energy_turned_over",
                                         "energy_imbalance_max",
                                         "momentum_imbalance_max",
                                         "energy_jump_max",
                                         "penetration_max",
                                         "contact_pressure_max",
                                         "energy",
                                         "window_energy",
                                         "losses",
                                         "statistics",
                                         "impacts"};
constexpr const char *last_members[]  = {"checks",
                                         "drive",
                                         "critical_time_step",
                                         "time_step",
                                         "steps",
                                         "searches",
                                         "window",
                                         "until",
                                         "ranks",
                                         "memory_peak",
                                         "wall_seconds",
                                         "cpu_seconds",
                                         "engagements"};
} // namespace

files::Json in_order(const files::Json &values)
{
  files::Json rest = values, ordered = files::Json::object(), end = files::Json::object();
  const auto  move = [&rest](const char *name, files::Json &to) {
    if (rest.contains(name))
      to[name] = rest[name];
    rest.erase(name);
  };
  for (const char *name : first_members)
    move(name, ordered);
  for (const char *name : last_members)
    move(name, end);
  ordered.update(rest);
  ordered.update(end);
  return ordered;
}

files::Json cpu_seconds(const std::vector<PhaseTimer::Row> &rows)
{
  files::Json result = files::Json::object();
  double      total  = 0.;
  for (const PhaseTimer::Row &row : rows)
    {
      std::string name = row.name;
      std::transform(name.begin(), name.end(), name.begin(), [](const unsigned char c) {
        return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : '_';
      });
      result[name] = row.cpu_seconds;
      total += row.cpu_seconds;
    }
  result["total"] = total;
  return result;
}

double memory_peak(const MPI_Comm comm)
{
  dealii::Utilities::System::MemoryStats memory; // in KiB
  dealii::Utilities::System::get_memory_stats(memory);
  return 1024. * dealii::Utilities::MPI::sum(static_cast<double>(memory.VmHWM), comm);
}

std::vector<PhaseTimer::Row> rows_of_all_ranks(const PhaseTimer &timer, const MPI_Comm comm)
{
  std::vector<PhaseTimer::Row> rows = timer.rows();
  std::vector<double>          seconds;
  seconds.reserve(rows.size());
  for (const PhaseTimer::Row &row : rows)
    seconds.push_back(row.cpu_seconds);
  dealii::Utilities::MPI::sum(seconds, comm, seconds);
  const double total = std::accumulate(seconds.begin(), seconds.end(), 0.);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = {rows[i].name, seconds[i], 100. * seconds[i] / total};
  return rows;
}
} // namespace chaindrive::observe
