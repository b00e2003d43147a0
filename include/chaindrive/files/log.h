// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <ostream>
#include <string>

namespace chaindrive::files
{
/// Where the program speaks: to the console and, once open() has named it, to a log file. What was
/// said before open() is in the file as well.
class Log : public std::ostream
{
public:
  /// Without a console (`--quiet`, or a rank other than the first) only the file is written, and
  /// warnings go to @p warnings, if there is that.
  explicit Log(std::ostream *console, std::ostream *warnings = nullptr);
  ~Log() override;

  /// Starts the file @p path, or goes on with it (@p append); RunError when it cannot be written.
  void open(const std::string &path, bool append = false);

  /// Completes the file; RunError when something said could not be written to it.
  void close();

  /// The last line of a run that failed: for the file alone, since main() says it on the console.
  /// Returns @p line, even when the file cannot be written.
  std::string end_with(std::string line);

  /// A line that is to be seen even by who asked for quiet.
  void warn(const std::string &line);

  /// A line for the console alone, which takes the place of the last one; it vanishes when
  /// something else is said. For terminals. Left out while a Console is behind.
  void show_status(const std::string &line);

  /// A line for the file alone.
  void write_to_file(const std::string &line);

private:
  class Tee;
  std::unique_ptr<Tee> tee_;
};
} // namespace chaindrive::files
