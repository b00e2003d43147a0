// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/command_line.h>

#include <mpi.h>

namespace chaindrive
{
/// Reads the .prm file named on the command line and runs it from parameters to results. Throws
/// InputError for input that cannot be run and RunError for a run that failed. Collective: elastic
/// bodies are dealt out to the ranks of @p comm; lumped and rigid models are too small for that,
/// the first rank computes them alone. Returns whether the run came to its end: false when a signal
/// or the wall-clock limit stopped it, after a checkpoint was written.
bool simulate(const CommandLine &command_line, MPI_Comm comm);
} // namespace chaindrive
