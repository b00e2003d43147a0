// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace chaindrive
{
/// The largest memory of this process so far, resident pages, bytes; 0 where the system does not
/// tell [proc(5), VmHWM of /proc/self/status]. Linux gives a copy of a process, made by fork(), all
/// pages of data, but pages of files, as of the libraries, only as the copy touches them: here they
/// count as well, as many as the process had at remember_pages_of_files(), or the copy has if these
/// are more. That makes the figure of a copy that of a process which was started as usual, less
/// what pages it has touched that the other one had not: a tenth at most was seen.
double largest_memory();

/// To be called before this process makes a copy of itself; see largest_memory().
void remember_pages_of_files();
} // namespace chaindrive
