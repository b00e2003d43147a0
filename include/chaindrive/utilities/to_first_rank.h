// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>
#include <vector>

namespace chaindrive
{
/// Numbers on their way from this rank to the first one, while this one goes on.
class ToFirstRank
{
public:
  ToFirstRank() = default;
  ~ToFirstRank();
  ToFirstRank(const ToFirstRank &)            = delete;
  ToFirstRank &operator=(const ToFirstRank &) = delete;

  /// Room for numbers to be sent, empty once the last ones have left, which this waits for.
  std::vector<double> &numbers();

  /// Sends what is there. The first rank of @p comm receives it with the same @p tag, in the order
  /// in which it was sent.
  void send(MPI_Comm comm, int tag);

private:
  std::vector<double> numbers_;
  MPI_Request         request_ = MPI_REQUEST_NULL;
};

/// Sums on the first rank, which waits for the numbers of the others; these do not wait.
class SumOnFirstRank
{
public:
  /// On the first rank of @p comm @p numbers become the sums, or the largest, of those of all
  /// ranks, which have as many; on others they stay as they are. Ranks are taken in turn.
  /// Collective, with one @p tag for each of the sums that may be on their way at once.
  void sum(std::vector<double> &numbers, MPI_Comm comm, int tag);
  void max(std::vector<double> &numbers, MPI_Comm comm, int tag);

private:
  template <typename Combine>
  void combine(std::vector<double> &numbers, MPI_Comm comm, int tag, const Combine &combine);

  ToFirstRank         own_;
  std::vector<double> received_;
};
} // namespace chaindrive
