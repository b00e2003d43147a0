// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::files
{
/// Texts stored with a file: name and value.
using Attributes = std::vector<std::pair<std::string, std::string>>;

/// One dataset of a HistoryFile: a table of numbers with one row per sample.
struct TableInfo
{
  std::string              path;           ///< "/name" or "/group/name"
  unsigned int             columns;        ///< a table with one column is a one-dimensional dataset
  Attributes               attributes;     ///< of the dataset
  std::vector<std::string> labels;         ///< attribute `columns`, none when empty
  bool                     single = false; ///< stored in single precision
};

class PackedRows;

/// An HDF5 file of tables that all have the same rows. Space for the rows is taken and filled with
/// NaN when the file is made, so that afterwards only numbers are replaced: the file is valid at
/// every instant, and other programs may read it meanwhile.
///
/// Every member function throws a RunError when the file cannot be written. The file is then
/// abandoned: what it holds stays, and further calls have no effect on it.
class HistoryFile
{
public:
  /// Makes the file with @p rows rows, stored in pieces of @p block rows.
  HistoryFile(const std::string            &path,
              const Attributes             &attributes,
              const std::vector<TableInfo> &tables,
              std::size_t                   rows,
              std::size_t                   block);

  /// Puts a compressed copy in the place of the complete file @p path, which has these tables, all
  /// at once: a reader finds one or the other. Blocks of rows are shuffled and deflated, which
  /// every HDF5 library reads: those that are @p packed are taken from there, the others read.
  /// Where there is no room for the copy, or another program has locked, cut or removed the file,
  /// that stays as it is. Returns why, a sentence, or nothing.
  static std::string compress(const std::string            &path,
                              const Attributes             &attributes,
                              const std::vector<TableInfo> &tables,
                              const PackedRows             &packed);

  /// Opens a complete file to read these tables of it; InputError when it has them not, or other
  /// numbers of columns.
  HistoryFile(const std::string &path, const std::vector<TableInfo> &tables);

  /// Leaves the file as it is, with all its rows.
  ~HistoryFile();

  /// Replaces the rows [first, first + n) of every table by @p values[table], row by row; adds rows
  /// when there are not enough.
  void write(std::size_t first, std::size_t n, const std::vector<std::vector<double>> &values);

  /// The rows [first, first + n) of every table into the beginning of @p values[table].
  void read(std::size_t first, std::size_t n, std::vector<std::vector<double>> &values);

  std::size_t n_rows() const;

  /// Cuts the tables to @p rows rows and closes the file.
  void close(std::size_t rows);

private:
  HistoryFile();

  struct Data;
  std::unique_ptr<Data> data_;
};
} // namespace chaindrive::files
