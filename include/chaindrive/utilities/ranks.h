// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

namespace chaindrive
{
/// This process's number in @p comm; 0 in a program that has not started MPI, such as a test.
inline unsigned int rank_in(const MPI_Comm comm)
{
  return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::this_mpi_process(comm) :
             0;
}

/// The number of processes in @p comm; 1 in a program that has not started MPI.
inline unsigned int n_ranks_in(const MPI_Comm comm)
{
  return dealii::Utilities::MPI::job_supports_mpi() ?
             dealii::Utilities::MPI::n_mpi_processes(comm) :
             1;
}
} // namespace chaindrive
