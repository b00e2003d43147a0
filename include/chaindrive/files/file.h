// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace chaindrive::files
{
/// A file that is written through a stream and knows why a write failed. Text is kept in memory and
/// handed to the system in pieces of 64 KiB.
class File : public std::ostream
{
public:
  /// Creates the file or empties it, unless @p append; RunError when that fails. Messages call it
  /// @p name, by default its path.
  explicit File(const std::string &path, const std::string &name = "", bool append = false);

  /// Closes the file; a failure then is not reported.
  ~File() override;

  /// Hands everything written so far to the system. When that fails the file is cut back to what
  /// the last successful call left in it, and a RunError names the file and the reason.
  void complete();

  /// complete(), then waits until the system has written everything to the disk.
  void sync();

  /// complete(), then closes the file and reports what the system says then.
  void close();

private:
  class Buffer;

  const std::string       name_;
  std::unique_ptr<Buffer> buffer_;
};

/// Opens a new file @p path to be written. What stood there goes, of a symbolic link the link and
/// not what it leads to; a device is opened as it is. Returns the descriptor, or -1 with errno.
int create_anew(const std::string &path);

/// The sentence of a RunError: file and reason, the latter from @p error_number (errno).
std::string write_failure(const std::string &path, int error_number);

/// Writes a whole file at once: @p write fills `path.part`, which then takes the place of @p path.
/// When anything fails `path.part` is removed, @p path stays as it was and a RunError is thrown.
/// With @p durable it and its new name have reached the disk by then.
void write_file(const std::string                         &path,
                const std::function<void(std::ostream &)> &write,
                bool                                       durable = false);

/// Waits until what was written to the file @p path, and its name, have reached the disk.
void sync_file(const std::string &path);

/// The same for a text at hand.
void write_text(const std::string &path, const std::string &text);

/// The file called @p name: as it is if the path is absolute, else in the first of @p folders that
/// has it. Throws InputError, with the places looked at, if none has; and for a folder.
std::string find_file(const std::string &name, const std::vector<std::string> &folders);

/// The whole content of a file; InputError when it cannot be read.
std::string read_text(const std::string &path);
} // namespace chaindrive::files
