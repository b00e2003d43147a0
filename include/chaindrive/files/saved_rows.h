// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/history_file.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/checksum.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::files
{
/// What a checkpoint knows of the histories that it counts on.
struct SavedMark
{
  std::uint64_t             rows     = 0;
  std::uint64_t             checksum = 0;  ///< Checksum of all numbers, row after row
  std::vector<std::string>  tables   = {}; ///< paths in the HDF5 file, in the order of a row
  std::vector<unsigned int> columns  = {}; ///< of each table

  void        serialize(const Archive &archive);
  std::size_t row_bytes() const;
};

/// The rows of histories that checkpoints count on, in a file of their own, `<prefix>.saved`: the
/// numbers of all tables, row after row, as the machine has them, and nothing else. Rows are only
/// added at its end: what happens to the newest ones does not touch what an older checkpoint needs.
class SavedRows
{
public:
  SavedRows(std::string prefix, const std::vector<TableInfo> &tables, std::size_t block);

  /// Adds the rows of @p file up to @p end and returns when they have reached the disk; RunError
  /// when that fails.
  void add(HistoryFile &file, std::size_t end);

  /// Of the rows added, or read, so far.
  SavedMark mark() const;

  /// Takes up the rows of @p mark, to read them: from `<prefix>.saved` or, if they are not there or
  /// damaged, from `<prefix>.h5`, which it then puts into that file. InputError when neither has
  /// them, or when they are of other tables.
  void open(const SavedMark &mark);

  /// The next @p n rows, into the beginning of @p values[table].
  void read(std::size_t n, std::vector<std::vector<double>> &values);

  /// Removes the file; `<prefix>.h5` has reached the disk before.
  static void remove(const std::string &prefix);

private:
  void write(std::ostream &out, HistoryFile &file, std::size_t end);

  std::string             prefix_;
  SavedMark               mark_; ///< of what was added or read so far, but for the checksum
  std::optional<Checksum> sum_;
  std::size_t             block_; ///< rows that are read at once
};

/// Throws InputError when neither `<prefix>.saved` nor `<prefix>.h5` has the rows of @p mark,
/// undamaged; changes nothing.
void check_saved_rows(const std::string &prefix, const SavedMark &mark);
} // namespace chaindrive::files
