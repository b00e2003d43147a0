// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/timing.h>
#include <chaindrive/utilities/to_first_rank.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <exception>

namespace chaindrive
{
ToFirstRank::~ToFirstRank()
{
  if (request_ == MPI_REQUEST_NULL)
    return;
  // after an error elsewhere nobody may receive it
  if (std::uncaught_exceptions() > 0)
    MPI_Request_free(&request_);
  else
    MPI_Wait(&request_, MPI_STATUS_IGNORE);
}

std::vector<double> &ToFirstRank::numbers()
{
  if (request_ != MPI_REQUEST_NULL)
    {
      const Waiting waiting;
      const int     status = MPI_Wait(&request_, MPI_STATUS_IGNORE);
      AssertThrowMPI(status);
    }
  numbers_.clear();
  return numbers_;
}

void ToFirstRank::send(const MPI_Comm comm, const int tag)
{
  const int status =
      MPI_Isend(numbers_.data(), int(numbers_.size()), MPI_DOUBLE, 0, tag, comm, &request_);
  AssertThrowMPI(status);
}

template <typename Combine>
void SumOnFirstRank::combine(std::vector<double> &numbers,
                             const MPI_Comm       comm,
                             const int            tag,
                             const Combine       &combine)
{
  if (rank_in(comm) > 0)
    {
      own_.numbers() = numbers;
      own_.send(comm, tag);
      return;
    }
  received_.resize(numbers.size());
  for (unsigned int rank = 1; rank < n_ranks_in(comm); ++rank)
    {
      {
        const Waiting waiting;
        const int     status = MPI_Recv(received_.data(),
                                    int(received_.size()),
                                    MPI_DOUBLE,
                                    int(rank),
                                    tag,
                                    comm,
                                    MPI_STATUS_IGNORE);
        AssertThrowMPI(status);
      }
      std::transform(numbers.begin(), numbers.end(), received_.begin(), numbers.begin(), combine);
    }
}

void SumOnFirstRank::sum(std::vector<double> &numbers, const MPI_Comm comm, const int tag)
{
  combine(numbers, comm, tag, [](const double a, const double b) { return a + b; });
}

void SumOnFirstRank::max(std::vector<double> &numbers, const MPI_Comm comm, const int tag)
{
  combine(numbers, comm, tag, [](const double a, const double b) { return std::max(a, b); });
}
} // namespace chaindrive
