// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/known_repeats.h>
#include <chaindrive/files/vtu.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <libdeflate.h>
#include <memory>
#include <new>
#include <ostream>
#include <type_traits>

namespace chaindrive::files
{
namespace
{
/// Collects the data arrays: their descriptions as XML, their numbers for the binary part at the
/// end of the file.
class Arrays
{
public:
  explicit Arrays(VtuPacked &before) : before_(before), binary_(before.binary) { binary_.clear(); }

  /// @p stretches, if there are any, of @p values, which are as in append_known_repeats().
  template <typename Number>
  std::string add(const std::string          &type,
                  const std::string          &name,
                  const unsigned int          components,
                  const std::vector<Number>  &values,
                  const std::vector<Stretch> &stretches = {})
  {
    std::string xml = "<DataArray type=\"" + type + "\" Name=\"" + name +
                      "\" NumberOfComponents=\"" + std::to_string(components) +
                      "\" format=\"appended\" offset=\"" + std::to_string(binary_.size()) +
                      "\"/>\n";
    const char       *bytes = reinterpret_cast<const char *>(values.data());
    const std::size_t size  = values.size() * sizeof(Number);
    if (std::is_floating_point_v<Number>)
      append(bytes, size, stretches);
    else
      {
        VtuPacked::Array &known = before_.arrays[name];
        if (known.packed.empty() || known.plain.compare(0, std::string::npos, bytes, size) != 0)
          {
            const std::size_t begin = binary_.size();
            append(bytes, size, {});
            known = {std::string(bytes, size), binary_.substr(begin)};
            return xml;
          }
        binary_ += known.packed;
      }
    return xml;
  }

  const std::string &binary() const { return binary_; }

private:
  /// What an array begins with: blocks, their size, size of the last if smaller, compressed sizes.
  static std::vector<std::uint64_t> header_of(const std::size_t size)
  {
    const std::size_t          n_blocks = (size + block - 1) / block;
    std::vector<std::uint64_t> header{n_blocks, block, size % block};
    header.resize(3 + n_blocks);
    return header;
  }

  /// Header and compressed blocks, to the end of what there is: by their repeats where a block has
  /// numbers of @p stretches that do.
  void append(const char *bytes, const std::size_t size, const std::vector<Stretch> &stretches)
  {
    constexpr std::size_t      word     = 4;
    std::vector<std::uint64_t> header   = header_of(size);
    const std::size_t          n_blocks = header[0], begin = binary_.size(),
                      header_size = header.size() * sizeof(std::uint64_t);
    binary_.resize(begin + header_size);
    for (std::size_t b = 0; b < n_blocks; ++b)
      {
        const std::size_t before = binary_.size(), first = b * block,
                          length = std::min(block, size - first);
        if (any_repeat(stretches, first / word, length / word))
          append_known_repeats(
              bytes, first / word, length / word, stretches, before_.room, binary_);
        else
          append_block(bytes + first, length);
        header[3 + b] = binary_.size() - before;
      }
    std::memcpy(&binary_[begin], header.data(), header_size);
  }

  void append_block(const char *bytes, const std::size_t length)
  {
    libdeflate_compressor *compressor = pays(bytes, length) ? compressor_.get() : stores_.get();
    const std::size_t      end        = binary_.size();
    const std::size_t      room       = libdeflate_zlib_compress_bound(compressor, length);
    binary_.resize(end + room);
    binary_.resize(end + libdeflate_zlib_compress(compressor, bytes, length, &binary_[end], room));
  }

  /// Whether a block shrinks by more than a third, as pieces of it tell. Digits of what is
  /// simulated do not: they would cost most of the time, for a tenth of the file.
  bool pays(const char *bytes, const std::size_t length) const
  {
    constexpr std::size_t n_pieces = 8, piece = 1 << 11, size = n_pieces * piece;
    if (length <= size)
      return true;
    std::string pieces;
    for (std::size_t i = 0; i < n_pieces; ++i) // each begins with a number
      pieces.append(bytes + i * (length - piece) / (n_pieces - 1) / 4 * 4, piece);
    const std::size_t room = 2 * size / 3; // nothing is returned if this is too little
    std::string       packed(room, '\0');
    return libdeflate_zlib_compress(compressor_.get(), pieces.data(), size, &packed[0], room) > 0;
  }

  struct Free
  {
    void operator()(libdeflate_compressor *compressor) const
    {
      libdeflate_free_compressor(compressor);
    }
  };
  using Compressor = std::unique_ptr<libdeflate_compressor, Free>;

  static Compressor make_compressor(const int level)
  {
    Compressor compressor(libdeflate_alloc_compressor(level));
    if (compressor == nullptr)
      throw std::bad_alloc();
    return compressor;
  }

  static constexpr std::size_t block = 1 << 18; ///< bytes that are compressed together

  static constexpr int level       = 1; ///< as small as 2 and 3, in six tenths of the time
  Compressor           compressor_ = make_compressor(level), stores_ = make_compressor(0);
  VtuPacked           &before_;
  std::string         &binary_;
};

/// Of @p n items, of which most have the @p components numbers that the one before has.
Stretch as_before(const unsigned int components, const std::size_t n)
{
  return {components * n, {{components, 0}}};
}

/// Appends @p n numbers of a body that deforms.
void add_deformed(std::vector<Stretch> &stretches, const std::size_t n)
{
  if (stretches.empty() || stretches.back().repeats())
    stretches.push_back({0, {}});
  stretches.back().n += n;
}

/// Of an array of @p components numbers at each point of the bodies of @p grid.
std::vector<Stretch> at_points(const VtuGrid &grid, const unsigned int components)
{
  std::vector<Stretch> stretches;
  for (const VtuGrid::Body &body : grid.bodies)
    if (body.deforms)
      add_deformed(stretches, components * body.n_points);
    else
      stretches.push_back({components * body.n_points, {{components, components * body.period}}});
  return stretches;
}

std::vector<Stretch> at_points(const VtuGrid &grid, const VtuGrid::FloatData &data)
{
  if (data.repeats)
    return {as_before(data.components, data.values.size() / data.components)};
  return at_points(grid, data.components);
}

/// Those of rigid bodies have one number for all of a body or gap.
std::vector<Stretch>
in_cells(const VtuGrid &grid, const VtuGrid::FloatData &data, const std::size_t n_cells)
{
  if (data.repeats)
    return {as_before(data.components, n_cells)};
  std::vector<Stretch> stretches;
  for (const VtuGrid::Body &body : grid.bodies)
    if (body.deforms)
      add_deformed(stretches, data.components * body.n_cells);
    else
      stretches.push_back(as_before(data.components, body.n_cells));
  return stretches;
}
} // namespace

void write_vtu(std::ostream &out, const VtuGrid &grid, const double time, VtuPacked &before)
{
  const std::size_t points_per_cell = grid.cell == VtuGrid::Cell::line ? 2 :
                                      grid.cell == VtuGrid::Cell::quad ? 4 :
                                                                         8;
  const std::size_t n_cells         = grid.connectivity.size() / points_per_cell;

  std::vector<std::int32_t> offsets(n_cells);
  for (std::size_t c = 0; c < n_cells; ++c)
    offsets[c] = (c + 1) * points_per_cell;
  const std::vector<std::uint8_t> types(n_cells, static_cast<std::uint8_t>(grid.cell));

  Arrays arrays(before);
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
      << "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
         "format=\"ascii\">"
      << time << "</DataArray>\n</FieldData>\n"
      << "<Piece NumberOfPoints=\"" << grid.points.size() / 3 << "\" NumberOfCells=\"" << n_cells
      << "\">\n<Points>\n"
      << arrays.add("Float32", "position", 3, grid.points, at_points(grid, 3))
      << "</Points>\n<Cells>\n"
      << arrays.add("Int32", "connectivity", 1, grid.connectivity)
      << arrays.add("Int32", "offsets", 1, offsets) << arrays.add("UInt8", "types", 1, types)
      << "</Cells>\n<PointData>\n";
  for (const VtuGrid::FloatData &data : grid.point_data)
    out << arrays.add("Float32", data.name, data.components, data.values, at_points(grid, data));
  out << "</PointData>\n<CellData>\n";
  for (const VtuGrid::IntegerData &data : grid.cell_numbers)
    out << arrays.add("Int32", data.name, 1, data.values);
  for (const VtuGrid::FloatData &data : grid.cell_data)
    out << arrays.add(
        "Float32", data.name, data.components, data.values, in_cells(grid, data, n_cells));
  out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_"
      << arrays.binary() << "\n</AppendedData>\n</VTKFile>\n";
}

void write_pvtu(std::ostream &out, const VtuGrid &grid, const std::vector<std::string> &pieces)
{
  const auto declare =
      [&out](const std::string &type, const std::string &name, const unsigned int components) {
        out << "<PDataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
            << components << "\"/>\n";
      };
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n";
  declare("Float32", "position", 3);
  out << "</PPoints>\n<PPointData>\n";
  for (const VtuGrid::FloatData &data : grid.point_data)
    declare("Float32", data.name, data.components);
  out << "</PPointData>\n<PCellData>\n";
  for (const VtuGrid::IntegerData &data : grid.cell_numbers)
    declare("Int32", data.name, 1);
  for (const VtuGrid::FloatData &data : grid.cell_data)
    declare("Float32", data.name, data.components);
  out << "</PCellData>\n";
  for (const std::string &piece : pieces)
    out << "<Piece Source=\"" << piece << "\"/>\n";
  out << "</PUnstructuredGrid>\n</VTKFile>\n";
}
} // namespace chaindrive::files
