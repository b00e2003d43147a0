// SPDX-License-Identifier: LGPL-2.1-or-later
// Phases: self times of nested scopes in a known ratio, the sum, the table, and the price.
#include <chaindrive/utilities/timing.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <sstream>

using namespace chaindrive;

/// Works until this process has used @p seconds more of CPU time.
void work(const double seconds)
{
  const double end = PhaseTimer::total() + seconds;
  while (PhaseTimer::total() < end)
    ;
}

int main()
{
  PhaseTimer timer;
  const auto force   = timer.add("Internal force");
  const auto contact = timer.add("Contact algorithm");
  const auto again   = timer.add("Internal force");
  timer.add("Never entered");
  std::cout << "one phase per name: " << (force == again ? "yes" : "no") << std::endl;

  // short pieces, so that what other programs take is spread over all phases
  for (unsigned int i = 0; i < 200; ++i)
    {
      const PhaseTimer::Scope outer(timer, force);
      work(0.0002);
      {
        const PhaseTimer::Scope inner(timer, contact);
        work(0.0006);
      }
      work(0.0001);
    }
  const auto rows = timer.rows();
  double     sum = 0., percentage = 0.;
  for (const PhaseTimer::Row &row : rows)
    {
      std::cout << row.name << std::endl;
      sum += row.cpu_seconds;
      percentage += row.percentage;
    }
  // 0.3 ms and 0.6 ms each, by the operating system's account of CPU time; were the inner phase
  // counted twice, the ratio would be 0.67
  const double ratio = rows[1].cpu_seconds / rows[0].cpu_seconds;
  std::cout << "ratio of self times 2, within 30 %: " << (ratio > 1.4 && ratio < 2.6 ? "yes" : "no")
            << std::endl
            << "never entered takes nothing: " << (rows[2].cpu_seconds == 0. ? "yes" : "no")
            << std::endl
            << "the rest is positive: " << (rows[3].cpu_seconds > 0. ? "yes" : "no") << std::endl
            << "sum of all is the process's time within 1 %: "
            << (std::abs(sum / PhaseTimer::total() - 1.) < 0.01 ? "yes" : "no") << std::endl
            << "percentages add up to " << percentage << std::endl;

  constexpr unsigned int n      = 1000000;
  const double           before = PhaseTimer::total();
  for (unsigned int i = 0; i < n; ++i)
    timer.enter(i % 2 == 0 ? force : contact);
  std::cout << "a change of phase costs less than 100 ns: "
            << ((PhaseTimer::total() - before) / n < 100e-9 ? "yes" : "no") << std::endl;

  // waiting, for 40 ms within a phase of 20 ms, is a row of its own
  PhaseTimer other;
  other.count_waiting();
  const auto step = other.add("Step");
  for (unsigned int i = 0; i < 20; ++i)
    {
      const PhaseTimer::Scope scope(other, step);
      work(0.001);
      {
        const Waiting waiting;
        work(0.002);
      }
    }
  const auto               of_step = other.rows();
  const PhaseTimer::OfRank of_rank = PhaseTimer::of_this_rank();
  std::cout << of_step[1].name << ": "
            << (of_step[1].cpu_seconds > 0.04 && of_step[1].cpu_seconds < 0.044 ? "yes" : "no")
            << std::endl
            << "and not in the phase: "
            << (of_step[0].cpu_seconds > 0.012 && of_step[0].cpu_seconds < 0.028 ? "yes" : "no")
            << std::endl
            << "busy and waiting are all: "
            << (of_rank.waiting > 0.04 && of_rank.waiting < 0.044 &&
                        std::abs((of_rank.busy + of_rank.waiting) / PhaseTimer::total() - 1.) <
                            0.01 ?
                    "yes" :
                    "no")
            << std::endl;

  std::ostringstream out;
  timer.print(out);
  const std::string table = out.str();
  std::cout << "lines of the table: " << std::count(table.begin(), table.end(), '\n') << std::endl;
}
