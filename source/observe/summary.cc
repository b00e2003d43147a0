// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/summary.h>
#include <chaindrive/utilities/memory.h>
#include <chaindrive/utilities/ranks.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <numeric>
#include <utility>

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
  return dealii::Utilities::MPI::sum(largest_memory(), comm);
}

std::vector<PhaseTimer::OfRank> of_ranks(const MPI_Comm comm)
{
  std::vector<PhaseTimer::OfRank> ranks;
  if (n_ranks_in(comm) == 1)
    return ranks;
  const PhaseTimer::OfRank own = PhaseTimer::of_this_rank();
  for (const auto &[busy, waiting] :
       dealii::Utilities::MPI::all_gather(comm, std::make_pair(own.busy, own.waiting)))
    ranks.push_back({busy, waiting});
  return ranks;
}

void print_ranks(std::ostream &out, const std::vector<PhaseTimer::OfRank> &ranks)
{
  constexpr std::size_t most_listed = 8;
  if (ranks.empty())
    return;
  char       line[128];
  const auto add_row = [&](const std::string &name, const PhaseTimer::OfRank &rank) {
    std::snprintf(
        line, sizeof(line), "%-36s %12.3E %15.3E\n", name.c_str(), rank.busy, rank.waiting);
    out << line;
  };
  std::snprintf(line, sizeof(line), "%-36s %12s %15s\n", "CPU time (s)", "Busy", "Waiting");
  out << line;
  if (ranks.size() <= most_listed)
    {
      for (std::size_t rank = 0; rank < ranks.size(); ++rank)
        add_row("Rank " + std::to_string(rank), ranks[rank]);
      return;
    }
  const auto [least, most] = std::minmax_element(
      ranks.begin(), ranks.end(), [](const auto &a, const auto &b) { return a.busy < b.busy; });
  PhaseTimer::OfRank mean{0., 0.};
  for (const PhaseTimer::OfRank &rank : ranks)
    {
      mean.busy += rank.busy / static_cast<double>(ranks.size());
      mean.waiting += rank.waiting / static_cast<double>(ranks.size());
    }
  add_row("Rank " + std::to_string(least - ranks.begin()) + ", least busy", *least);
  add_row("Mean of " + std::to_string(ranks.size()) + " ranks", mean);
  add_row("Rank " + std::to_string(most - ranks.begin()) + ", busiest", *most);
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
