// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <memory>
#include <ostream>

namespace chaindrive::files
{
/// Standard output or standard error, which may lead to a reader who is slow, has stopped reading
/// or is gone: a pager, a terminal that is closed, mpirun after it got a signal. What is written is
/// handed over by a thread of its own and never keeps the program waiting; what the system refuses
/// is dropped.
class Console : public std::ostream
{
public:
  explicit Console(int descriptor);

  /// Waits until everything has been taken, or as give_up_after() says. A stop signal
  /// (utilities/signals.h) limits the wait to two seconds without progress.
  ~Console() override;

  /// At the end the reader may take nothing for so long, then what is left is dropped. To be called
  /// when all that is said stands in a file as well; before, the wait is without limit.
  void give_up_after(std::chrono::milliseconds patience);

  /// Whether something that was written has not been taken yet.
  bool is_behind() const;

  /// Whether the system has refused something that was written to standard output, as a full disk
  /// does, or a pipe whose reader is gone.
  static bool output_was_refused();

private:
  class Queue;
  std::unique_ptr<Queue> queue_;
};
} // namespace chaindrive::files
