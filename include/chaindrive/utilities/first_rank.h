// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>

#include <string>

namespace chaindrive
{
/// Calls @p work on the first rank of @p comm. An InputError or RunError that it throws is thrown
/// by all ranks, so that none waits for one that has given up. Collective.
template <typename Work>
void on_first_rank(const MPI_Comm comm, const Work &work)
{
  enum : int
  {
    good,
    input,
    run
  };
  int         end = good;
  std::string message;
  if (rank_in(comm) == 0)
    try
      {
        work();
      }
    catch (const InputError &error)
      {
        end     = input;
        message = error.what();
      }
    catch (const RunError &error)
      {
        end     = run;
        message = error.what();
      }
  if (n_ranks_in(comm) > 1)
    {
      end     = dealii::Utilities::MPI::broadcast(comm, end);
      message = dealii::Utilities::MPI::broadcast(comm, message);
    }
  if (end == input)
    throw InputError(message);
  if (end == run)
    throw RunError(message);
}
} // namespace chaindrive
