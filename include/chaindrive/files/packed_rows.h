// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/history_file.h>

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace chaindrive::files
{
/// A block of rows of one table as it stands in a compressed file.
struct PackedChunk
{
  std::vector<unsigned char> bytes;
  bool                       deflated; ///< otherwise only shuffled: it would not have shrunk
};

/// Packs blocks of rows as the filters of the HDF5 library would, in a quarter of the time: bytes
/// are shuffled, that is sorted by their significance, and deflated.
class RowPacker
{
public:
  /// For blocks of @p block rows of these tables.
  RowPacker(const std::vector<TableInfo> &tables, std::size_t block);

  /// The first @p n rows of every @p values[table], row by row; those from n on become NaN.
  /// Returns a chunk for each table.
  std::vector<PackedChunk> pack(std::size_t n, std::vector<std::vector<double>> &values);

private:
  struct Free
  {
    void operator()(void *compressor) const;
  };

  void        shuffle(const std::vector<double> &values, bool single);
  bool        pays(const unsigned char *plane, std::size_t size) const;
  std::size_t pack_planes(std::size_t width, std::size_t size);

  std::vector<unsigned int>   columns_;
  std::vector<bool>           single_;
  std::size_t                 block_;
  std::unique_ptr<void, Free> compressor_;
  std::vector<unsigned char>  shuffled_, packed_; ///< of one table
};

/// Blocks that were packed when they were written, so that nobody need read them again.
class PackedRows
{
public:
  PackedRows(const std::vector<TableInfo> &tables, std::size_t block);

  /// The first @p n rows of every @p values[table] are the rows [first, first + n) of the file. The
  /// block that begins with them is packed, which the last one need not fill; of one that goes on
  /// with them nothing is known any more. Rows of @p values from n on become NaN.
  void add(std::size_t first, std::size_t n, std::vector<std::vector<double>> &values);

  /// The chunks of the block that begins with row @p first, or null.
  const std::vector<PackedChunk> *find(std::size_t first) const;

  std::size_t block() const { return block_; }

private:
  std::size_t                                     block_, bytes_ = 0;
  RowPacker                                       packer_;
  std::map<std::size_t, std::vector<PackedChunk>> blocks_; ///< by their first row
};
} // namespace chaindrive::files
