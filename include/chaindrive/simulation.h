// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/command_line.h>

namespace chaindrive
{
/// Reads the .prm file named on the command line and runs it from parameters to results. Throws
/// InputError for input that cannot be run and RunError for a run that failed.
void simulate(const CommandLine &command_line);
} // namespace chaindrive
