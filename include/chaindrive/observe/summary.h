// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/json.h>
#include <chaindrive/utilities/timing.h>

#include <mpi.h>
#include <ostream>
#include <string>
#include <vector>

namespace chaindrive::observe
{
/// What a run comes to.
struct Summary
{
  files::Json                  values; ///< of summary.json; their definitions are in doc/output.md
  std::vector<PhaseTimer::Row> phases; ///< where the CPU time went, of all ranks together
  std::vector<PhaseTimer::OfRank> ranks; ///< CPU time of each since it was started; of one none
};

/// The members of @p values in the order in which summary.json has them. Those that have no
/// place in it stand between the results and the key figures of the computation.
files::Json in_order(const files::Json &values);

/// CPU seconds by phase and `total`. Names become members in snake_case: "Internal force" ->
/// `internal_force`.
files::Json cpu_seconds(const std::vector<PhaseTimer::Row> &rows);

/// The rows of @p timer, of all ranks together. Collective.
std::vector<PhaseTimer::Row> rows_of_all_ranks(const PhaseTimer &timer, MPI_Comm comm);

/// PhaseTimer::of_this_rank() of each; none of a single one. Collective.
std::vector<PhaseTimer::OfRank> of_ranks(MPI_Comm comm);

/// A table of how long each rank was busy and waited; of many the least, the mean and the most busy
/// one. Nothing of none.
void print_ranks(std::ostream &out, const std::vector<PhaseTimer::OfRank> &ranks);

/// Largest memory that each process has had so far, their sum. Bytes. Collective.
double memory_peak(MPI_Comm comm);

/// The most asked for members of a run's summary, a line each, for the log.
void print_summary(std::ostream &out, const files::Json &summary);
} // namespace chaindrive::observe
