// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace chaindrive
{
/// A plug-in that is loaded.
struct Plugin
{
  std::string path; ///< absolute
  std::string name, version;
  std::string checksum; ///< of the file (utilities/checksum.h)
};

/// Loads the shared libraries @p files, which then belong to the program: what they register is
/// found like its own. InputError for a file that is not there, that is no shared library, no
/// plug-in, or one for another program (plugin.h), which is found out before any of it is run; for
/// two of one name; for one that registers nothing, or a name that there is; and where ranks do not
/// find the same files. Collective over @p comm.
void load_plugins(const std::vector<std::string> &files, MPI_Comm comm);

/// In the order of their loading.
const std::vector<Plugin> &loaded_plugins();

/// One line for the checks of a resumed run: names and versions, or none.
std::string plugins_text();

/// A line for each, with path, checksum and what it has registered; each begins with @p begin.
void print_plugins(std::ostream &out, const std::string &begin = "");
} // namespace chaindrive
