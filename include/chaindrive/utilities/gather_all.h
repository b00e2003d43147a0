// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/exceptions.h>

#include <climits>
#include <mpi.h>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace chaindrive
{
/// What all ranks of @p comm have, each @p own, one after the other, on each of them. Items travel
/// as they lie in memory, of all ranks together less than 2 GiB. Collective.
template <typename Item>
std::vector<Item> gather_all(std::vector<Item> own, const MPI_Comm comm)
{
  static_assert(std::is_trivially_copyable_v<Item>);
  const unsigned int n_ranks = n_ranks_in(comm);
  if (n_ranks == 1)
    return own;
  const std::size_t n_bytes = own.size() * sizeof(Item);
  AssertThrow(n_bytes <= INT_MAX / n_ranks, dealii::ExcMessage("One rank sends too much"));
  const int        bytes = static_cast<int>(n_bytes);
  std::vector<int> sizes(n_ranks), places(n_ranks, 0);
  const Waiting    waiting;
  const int        known = MPI_Allgather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, comm);
  AssertThrowMPI(known);
  std::partial_sum(sizes.begin(), sizes.end() - 1, places.begin() + 1);
  std::vector<Item> all((places.back() + sizes.back()) / sizeof(Item));
  const int         status = MPI_Allgatherv(
      own.data(), bytes, MPI_BYTE, all.data(), sizes.data(), places.data(), MPI_BYTE, comm);
  AssertThrowMPI(status);
  return all;
}
} // namespace chaindrive
