// SPDX-License-Identifier: LGPL-2.1-or-later
// Sums and largest numbers of three ranks on the first one, several on their way at once; the
// others do not wait for it, and keep theirs. The table of times has a row for what is waited for,
// and what the first one waits for a rank that comes late is there and in no phase.
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/timing.h>
#include <chaindrive/utilities/to_first_rank.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <iostream>
#include <thread>

using namespace chaindrive;

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm                                 comm = MPI_COMM_WORLD;
  const unsigned int                             rank = rank_in(comm), n = n_ranks_in(comm);
  using Clock = std::chrono::steady_clock;

  PhaseTimer timer;
  timer.count_waiting();
  const PhaseTimer::Phase phase = timer.add("Sums");
  bool                    right = true, kept = true;
  double                  took = 0., waited = 0.; // s; over what the first one takes
  {
    SumOnFirstRank          sums, largest;
    const PhaseTimer::Scope scope(timer, phase);
    for (unsigned int round = 0; round < 3; ++round)
      {
        std::vector<double> a(700, 0.), b = {-1., -5. + rank};
        for (unsigned int i = 0; i < a.size(); ++i)
          a[i] = (rank + 1.) * (i + round);
        const std::vector<double> own_a = a, own_b = b;
        MPI_Barrier(comm);
        const auto begin = Clock::now();
        if (rank == 0)
          std::this_thread::sleep_for(std::chrono::milliseconds(300));
        sums.sum(a, comm, 21);
        largest.max(b, comm, 22);
        took += std::chrono::duration<double>(Clock::now() - begin).count();
        if (rank == 0)
          {
            for (unsigned int i = 0; i < a.size(); ++i)
              right = right && a[i] == 0.5 * n * (n + 1) * (i + round);
            right = right && b[0] == -1. && b[1] == -5. + (n - 1);
          }
        else
          kept = kept && a == own_a && b == own_b;
      }
    MPI_Barrier(comm);
    if (rank == 1)
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
    std::vector<double> late   = {1.};
    const auto          before = time_stamp(), waited_before = Waiting::ticks();
    sums.sum(late, comm, 21);
    waited = static_cast<double>(Waiting::ticks() - waited_before) /
             static_cast<double>(time_stamp() - before);
    MPI_Barrier(comm);
  }
  const double longest  = dealii::Utilities::MPI::max(rank > 0 ? took : 0., comm);
  const bool   all_kept = dealii::Utilities::MPI::min(kept ? 1 : 0, comm) != 0;
  const auto   rows     = timer.rows();
  if (rank > 0)
    return 0;
  std::cout << "sums and largest numbers: " << (right ? "yes" : "no") << '\n'
            << "others keep theirs: " << (all_kept ? "yes" : "no") << '\n'
            << "while the first one sleeps for 0.9 s, they take less than half of that: "
            << (longest < 0.45 ? "yes" : "no") << '\n'
            << "while another one sleeps, the first one waits: " << (waited > 0.9 ? "yes" : "no")
            << '\n';
  for (const PhaseTimer::Row &row : rows)
    std::cout << row.name << '\n';
}
