// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/vtu.h>

#include <algorithm>
#include <libdeflate.h>
#include <memory>
#include <new>
#include <ostream>

namespace chaindrive::files
{
namespace
{
/// Collects the data arrays: their descriptions as XML, their numbers for the binary part at the
/// end of the file.
class Arrays
{
public:
  Arrays()
  {
    if (compressor_ == nullptr)
      throw std::bad_alloc();
  }

  template <typename Number>
  std::string add(const std::string         &type,
                  const std::string         &name,
                  const unsigned int         components,
                  const std::vector<Number> &values)
  {
    std::string xml = "<DataArray type=\"" + type + "\" Name=\"" + name +
                      "\" NumberOfComponents=\"" + std::to_string(components) +
                      "\" format=\"appended\" offset=\"" + std::to_string(binary_.size()) +
                      "\"/>\n";
    append(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(Number));
    return xml;
  }

  const std::string &binary() const { return binary_; }

private:
  /// A header of 64-bit numbers (blocks, their size, size of the last if smaller, compressed sizes)
  /// and the compressed blocks.
  void append(const char *bytes, const std::size_t size)
  {
    constexpr std::size_t      block    = 1 << 18;
    const std::size_t          n_blocks = (size + block - 1) / block;
    std::vector<std::uint64_t> header{n_blocks, block, size % block};
    std::string                packed;
    for (std::size_t b = 0; b < n_blocks; ++b)
      {
        const std::size_t length = std::min(block, size - b * block), end = packed.size(),
                          room = libdeflate_zlib_compress_bound(compressor_.get(), length);
        packed.resize(end + room);
        header.push_back(libdeflate_zlib_compress(
            compressor_.get(), bytes + b * block, length, &packed[end], room));
        packed.resize(end + header.back());
      }
    binary_.append(reinterpret_cast<const char *>(header.data()),
                   header.size() * sizeof(std::uint64_t));
    binary_ += packed;
  }

  struct Free
  {
    void operator()(libdeflate_compressor *compressor) const
    {
      libdeflate_free_compressor(compressor);
    }
  };

  static constexpr int level = 2; ///< as small as zlib's 1, in half the time
  std::unique_ptr<libdeflate_compressor, Free> compressor_{libdeflate_alloc_compressor(level)};
  std::string                                  binary_;
};
} // namespace

void write_vtu(std::ostream &out, const VtuGrid &grid, const double time)
{
  const std::size_t points_per_cell = grid.cell == VtuGrid::Cell::line ? 2 : 8;
  const std::size_t n_cells         = grid.connectivity.size() / points_per_cell;

  std::vector<std::int32_t> offsets(n_cells);
  for (std::size_t c = 0; c < n_cells; ++c)
    offsets[c] = (c + 1) * points_per_cell;
  const std::vector<std::uint8_t> types(n_cells, static_cast<std::uint8_t>(grid.cell));

  Arrays arrays;
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
      << "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
         "format=\"ascii\">"
      << time << "</DataArray>\n</FieldData>\n"
      << "<Piece NumberOfPoints=\"" << grid.points.size() / 3 << "\" NumberOfCells=\"" << n_cells
      << "\">\n<Points>\n"
      << arrays.add("Float32", "position", 3, grid.points) << "</Points>\n<Cells>\n"
      << arrays.add("Int32", "connectivity", 1, grid.connectivity)
      << arrays.add("Int32", "offsets", 1, offsets) << arrays.add("UInt8", "types", 1, types)
      << "</Cells>\n<PointData>\n";
  for (const VtuGrid::FloatData &data : grid.point_data)
    out << arrays.add("Float32", data.name, data.components, data.values);
  out << "</PointData>\n<CellData>\n";
  for (const VtuGrid::IntegerData &data : grid.cell_numbers)
    out << arrays.add("Int32", data.name, 1, data.values);
  for (const VtuGrid::FloatData &data : grid.cell_data)
    out << arrays.add("Float32", data.name, data.components, data.values);
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
