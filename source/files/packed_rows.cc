// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/packed_rows.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <libdeflate.h>
#include <limits>
#include <new>

namespace chaindrive::files
{
namespace
{
/// A hundredth larger than by zlib at 4.
constexpr int deflate_level = 1;

/// What is kept of a run [bytes]; blocks beyond it are read again.
constexpr std::size_t most_kept = std::size_t(64) << 20;

/// Byte b of number k becomes byte k of number b, of eight numbers, by swapping halves, quarters
/// and eighths (Warren, Hacker's Delight, section 7-3).
void transpose(std::array<std::uint64_t, 8> &x)
{
  const auto swap = [&x](const int k, const int distance, const std::uint64_t mask) {
    const std::uint64_t other = ((x[k] >> (8 * distance)) ^ x[k + distance]) & mask;
    x[k + distance] ^= other;
    x[k] ^= other << (8 * distance);
  };
  for (const int k : {0, 1, 2, 3})
    swap(k, 4, 0x00000000ffffffffU);
  for (const int k : {0, 1, 4, 5})
    swap(k, 2, 0x0000ffff0000ffffU);
  for (const int k : {0, 2, 4, 6})
    swap(k, 1, 0x00ff00ff00ff00ffU);
}

/// The bits of a number as it is stored.
std::uint64_t bits_of(const double value, const bool single)
{
  if (!single)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      return bits;
    }
  const auto    rounded = static_cast<float>(value);
  std::uint32_t bits;
  std::memcpy(&bits, &rounded, sizeof(bits));
  return bits;
}

libdeflate_compressor *compressor_of(void *of) { return static_cast<libdeflate_compressor *>(of); }
} // namespace

void RowPacker::Free::operator()(void *compressor) const
{
  libdeflate_free_compressor(compressor_of(compressor));
}

RowPacker::RowPacker(const std::vector<TableInfo> &tables, const std::size_t block)
    : block_(block), compressor_(libdeflate_alloc_compressor(deflate_level))
{
  if (compressor_ == nullptr)
    throw std::bad_alloc();
  for (const TableInfo &table : tables)
    {
      columns_.push_back(table.columns);
      single_.push_back(table.single);
    }
}

void RowPacker::shuffle(const std::vector<double> &values, const bool single)
{
  const std::size_t size = values.size(), width = single ? 4 : 8, whole = size / 8 * 8;
  shuffled_.resize(width * size);
  for (std::size_t i = 0; i < whole; i += 8)
    {
      std::array<std::uint64_t, 8> numbers;
      for (std::size_t k = 0; k < 8; ++k)
        numbers[k] = bits_of(values[i + k], single);
      transpose(numbers);
      for (std::size_t b = 0; b < width; ++b)
        std::memcpy(&shuffled_[b * size + i], &numbers[b], 8);
    }
  for (std::size_t i = whole; i < size; ++i)
    {
      const std::uint64_t bits = bits_of(values[i], single);
      for (std::size_t b = 0; b < width; ++b)
        shuffled_[b * size + i] = (bits >> (8 * b)) & 0xff;
    }
}

/// Whether a plane shrinks by an eighth or more, as a piece of it tells.
bool RowPacker::pays(const unsigned char *plane, const std::size_t size) const
{
  constexpr std::size_t piece = 1 << 12, room = 7 * piece / 8;
  if (size <= piece)
    return true;
  unsigned char packed[room];
  return libdeflate_deflate_compress(
             compressor_of(compressor_.get()), plane + (size - piece) / 2, piece, packed, room) > 0;
}

/// Packs @p width planes of @p size bytes each, the least significant first, as a stream of zlib's
/// format into `packed_`, which gets as much room as they take; returns its length, or 0 if that is
/// too little. The first planes are stored as long as they hardly shrink: most digits of what is
/// simulated do not, and would take most of the time.
std::size_t RowPacker::pack_planes(const std::size_t width, const std::size_t size)
{
  constexpr std::size_t longest = 65535, checksum_size = 4;
  const std::size_t     bytes  = width * size;
  const unsigned char  *planes = shuffled_.data();
  packed_.resize(bytes);
  std::size_t stored = 0, at = 2;
  while (stored + 1 < width && !pays(planes + stored * size, size))
    ++stored;
  if (bytes < 2 + stored * (size + 5 * (size / longest + 1)) + checksum_size)
    return 0;
  packed_[0] = 0x78;
  packed_[1] = 0x01;
  for (std::size_t from = 0, length; from < stored * size; from += length)
    {
      length        = std::min(longest, stored * size - from);
      packed_[at++] = 0; // a stored block, not the last one
      for (const std::size_t half : {length, ~length})
        {
          packed_[at++] = half & 0xff;
          packed_[at++] = (half >> 8) & 0xff;
        }
      std::copy_n(planes + from, length, packed_.begin() + at);
      at += length;
    }
  const std::size_t rest = libdeflate_deflate_compress(compressor_of(compressor_.get()),
                                                       planes + stored * size,
                                                       bytes - stored * size,
                                                       &packed_[at],
                                                       bytes - at - checksum_size);
  if (rest == 0)
    return 0;
  at += rest;
  const std::uint32_t adler = libdeflate_adler32(1, planes, bytes);
  for (const int shift : {24, 16, 8, 0})
    packed_[at++] = (adler >> shift) & 0xff;
  return at;
}

std::vector<PackedChunk> RowPacker::pack(const std::size_t                 n,
                                         std::vector<std::vector<double>> &values)
{
  std::vector<PackedChunk> chunks;
  for (std::size_t t = 0; t < columns_.size(); ++t)
    {
      const std::size_t size = block_ * columns_[t];
      std::fill(values[t].begin() + n * columns_[t],
                values[t].end(),
                std::numeric_limits<double>::quiet_NaN());
      shuffle(values[t], single_[t]);
      const std::size_t           length = pack_planes(shuffled_.size() / size, size);
      std::vector<unsigned char> &from   = length > 0 ? packed_ : shuffled_;
      chunks.push_back(
          {{from.begin(), length > 0 ? from.begin() + length : from.end()}, length > 0});
    }
  return chunks;
}

PackedRows::PackedRows(const std::vector<TableInfo> &tables, const std::size_t block)
    : block_(block), packer_(tables, block)
{
}

void PackedRows::add(const std::size_t                 first,
                     const std::size_t                 n,
                     std::vector<std::vector<double>> &values)
{
  if (n == 0)
    return;
  blocks_.erase(first / block_ * block_);
  if (first % block_ != 0 || bytes_ > most_kept)
    return;
  std::vector<PackedChunk> &chunks = blocks_[first] = packer_.pack(n, values);
  for (const PackedChunk &chunk : chunks)
    bytes_ += chunk.bytes.size();
}

const std::vector<PackedChunk> *PackedRows::find(const std::size_t first) const
{
  const auto found = blocks_.find(first);
  return found == blocks_.end() ? nullptr : &found->second;
}
} // namespace chaindrive::files
