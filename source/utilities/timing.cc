// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/timing.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <numeric>
#include <ostream>

namespace chaindrive
{
double PhaseTimer::total()
{
  std::timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Waiting::Waiting() : begin_(time_stamp()), cpu_at_begin_(PhaseTimer::total()) {}

Waiting::~Waiting()
{
  cpu_seconds_ += PhaseTimer::total() - cpu_at_begin_;
  ticks_ += time_stamp() - begin_;
}

PhaseTimer::PhaseTimer()
    : names_{"Initiation and rest"}
    , ticks_{0}
    , start_(clock())
    , last_(start_)
    , cpu_at_start_(total())
    , waited_at_start_(Waiting::cpu_seconds())
{
}

PhaseTimer::Phase PhaseTimer::add(const std::string &name)
{
  const auto found = std::find(names_.begin() + 1, names_.end(), name);
  if (found != names_.end())
    return found - names_.begin();
  names_.push_back(name);
  ticks_.push_back(0);
  return names_.size() - 1;
}

std::vector<PhaseTimer::Row> PhaseTimer::rows() const
{
  const double cpu   = total();
  auto         ticks = ticks_;
  const auto   now   = clock();
  ticks[running_] += now - last_;

  const double waited = Waiting::cpu_seconds() - waited_at_start_;
  const double seconds_per_tick =
      (cpu - cpu_at_start_ - waited) / static_cast<double>(now - start_);
  std::vector<Row> rows;
  double           in_phases = 0.;
  for (Phase p = 1; p < names_.size(); ++p)
    {
      const double seconds = static_cast<double>(ticks[p]) * seconds_per_tick;
      rows.push_back({names_[p], seconds, 0.});
      in_phases += seconds;
    }
  if (counts_waiting_)
    {
      rows.push_back({"Waiting for other ranks", waited, 0.});
      in_phases += waited;
    }
  rows.push_back({names_[rest], cpu - in_phases, 0.});

  double all = 0.;
  for (std::size_t i = 0; i < rows.size(); ++i)
    all += rows[i].cpu_seconds += earlier_.size() == rows.size() ? earlier_[i] : 0.;
  for (Row &row : rows)
    row.percentage = 100. * row.cpu_seconds / all;
  return rows;
}

void PhaseTimer::print(std::ostream &out, const std::vector<Row> &table)
{
  char       line[128];
  const auto add_row = [&](const std::string &name, const double seconds, const double percentage) {
    std::snprintf(line, sizeof(line), "%-36s %12.3E %15.2f\n", name.c_str(), seconds, percentage);
    out << line;
  };
  std::snprintf(line, sizeof(line), "%-36s %12s %15s\n", "", "CPU time (s)", "Percentage (%)");
  out << line;
  for (const Row &row : table)
    add_row(row.name, row.cpu_seconds, row.percentage);
  // the sum of the rows, not another reading of the clock
  add_row("Total (including initiation time)",
          std::accumulate(table.begin(),
                          table.end(),
                          0.,
                          [](const double sum, const Row &row) { return sum + row.cpu_seconds; }),
          100.);
}
} // namespace chaindrive
