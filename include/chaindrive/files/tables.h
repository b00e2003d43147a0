// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/hdf5_object.h>
#include <chaindrive/files/history_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace chaindrive::files
{
/// A dataset with its numbers, row by row.
struct Table
{
  TableInfo           info;
  std::vector<double> values;

  std::size_t n_rows() const { return values.size() / info.columns; }
};

/// An HDF5 file of tables that is complete, such as histories.h5 of a run that has ended, to be
/// read by those who know little of it.
class TableFile
{
public:
  /// InputError when there is no such file or it is not HDF5.
  explicit TableFile(const std::string &path);

  bool has(const std::string &dataset) const;

  /// The rows [@p first, @p first + @p n) of @p dataset ("/group/name"), as many of them as it has,
  /// with the labels of its columns. InputError that names file and dataset when there is none, or
  /// it has not numbers in one or two dimensions, or it is damaged.
  Table
  read(const std::string &dataset, std::size_t first = 0, std::size_t n = std::size_t(-1)) const;

  const std::string &path() const { return path_; }

private:
  [[noreturn]] void refuse(const std::string &dataset, const std::string &why) const;

  std::vector<std::string> read_labels(const Hdf5Object &table, const std::string &dataset) const;

  const std::string path_;
  Hdf5Object        file_;
};

/// Writes @p tables, each with rows of its own, as an HDF5 file to @p path all at once. RunError
/// when it cannot be written.
void write_tables(const std::string        &path,
                  const Attributes         &attributes,
                  const std::vector<Table> &tables);
} // namespace chaindrive::files
