// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace chaindrive
{
/// What a piece of work has come to that was done in a process of its own.
struct WorkResult
{
  enum class End
  {
    none,      ///< it was not done, since a stop signal came
    good,      ///< #text is what it returned
    input,     ///< it threw InputError with the message #text
    memory,    ///< there was not enough memory for it
    exception, ///< it threw another exception with the message #text
    died       ///< the process ended otherwise, as #text says
  };

  End         end = End::none;
  std::string text;
};

/// Does @p work(0) ... @p work(n - 1), each in a copy of this process that knows what this one
/// knows, up to @p at_a_time of them together, and returns what they have come to, in this order.
/// What lacked memory or died is done once more at the end, alone. @p look is called whenever one
/// has come to its end, and else ten times a second, with their number so far. After a stop signal
/// (utilities/signals.h) those at work are ended and no others begin. RunError when no process can
/// be started. In the copies MPI is to be used among a single process only.
std::vector<WorkResult> do_in_processes(std::size_t                                    n,
                                        unsigned int                                   at_a_time,
                                        const std::function<std::string(std::size_t)> &work,
                                        const std::function<void(std::size_t)>        &look);
} // namespace chaindrive
