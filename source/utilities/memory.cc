// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/memory.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace chaindrive
{
namespace
{
double pages_of_files_before = 0.; ///< of the process that this one is a copy of, bytes

/// A number of kibibytes in /proc/self/status, in bytes; 0 where it has none of this @p name.
double status_of_memory(const std::string &name)
{
  std::ifstream status("/proc/self/status");
  std::string   word;
  while (status >> word)
    {
      double kibibytes = 0.;
      if (word == name + ":" && status >> kibibytes)
        return 1024. * kibibytes;
      status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
  return 0.;
}
} // namespace

double largest_memory()
{
  return status_of_memory("VmHWM") +
         std::max(0., pages_of_files_before - status_of_memory("RssFile"));
}

void remember_pages_of_files()
{
  pages_of_files_before = std::max(pages_of_files_before, status_of_memory("RssFile"));
}
} // namespace chaindrive
