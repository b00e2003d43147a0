// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/timing.h>

#include <nlohmann/json.hpp>

#include <mpi.h>
#include <ostream>
#include <string>
#include <vector>

namespace chaindrive::output
{
/// Keeps its members in the order in which they were added.
using Json = nlohmann::ordered_json;

/// Writes @p content to @p path all at once: a reader finds the old file or the new one, never a
/// part. Numbers keep all their digits; what is not a finite number becomes null. RunError when it
/// cannot be written.
void write_json(const std::string &path, const Json &content);

/// CPU seconds by phase and `total`. Names become members in snake_case: "Internal force" ->
/// `internal_force`.
Json cpu_seconds(const std::vector<PhaseTimer::Row> &rows);

/// The rows of @p timer, of all ranks together. Collective.
std::vector<PhaseTimer::Row> rows_of_all_ranks(const PhaseTimer &timer, MPI_Comm comm);

/// The most asked for members of a run's summary, a line each, for the log.
void print_summary(std::ostream &out, const Json &summary);
} // namespace chaindrive::output
