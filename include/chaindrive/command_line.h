// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace chaindrive
{
/// What the user asked for on the command line.
struct CommandLine
{
  std::string              parameter_file;
  std::vector<std::string> overrides;        ///< "Section/Entry=value", in the order given
  std::string              output_directory; ///< empty: what the .prm file says
  std::string              resume;           ///< empty: what the .prm file says
  bool                     plan                = false; ///< print what would be computed, and stop
  bool                     quiet               = false; ///< warnings and errors only
  bool                     write_parameters    = false; ///< print a template of a .prm file
  bool                     write_documentation = false; ///< print doc/parameters.md
  bool                     version             = false;
  bool                     help                = false;
};

/// Reads the arguments of main(). Throws InputError for an unknown option, naming the nearest one,
/// and when there is no .prm file although the options need one.
CommandLine parse_command_line(int argc, const char *const *argv);

/// What `--help` prints.
std::string help_text();

/// What `--version` prints: versions of the program and of deal.II, the SIMD instructions of this
/// processor, the width of the kernels that run on it (utilities/simd.h, whose InputError it
/// throws), and the number of MPI ranks.
std::string version_text();
} // namespace chaindrive
