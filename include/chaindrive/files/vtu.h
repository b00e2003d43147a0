// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace chaindrive::files
{
/// Cells of one shape that share their points, with numbers on points and cells, as VTK's XML
/// format for unstructured grids stores them.
struct VtuGrid
{
  enum class Cell : std::uint8_t
  {
    line       = 3,
    quad       = 9,
    hexahedron = 12
  };

  /// A named field: @p components numbers for each point or cell.
  struct FloatData
  {
    std::string        name;
    unsigned int       components;
    std::vector<float> values;
    bool               repeats = false; ///< most have what the one before has: makes files faster
  };
  struct IntegerData
  {
    std::string               name;
    std::vector<std::int32_t> values;
  };

  struct Body
  {
    std::size_t n_points, n_cells;
    std::size_t
         period; ///< points, besides one, after which coordinates are often the same; 0: none
    bool deforms = false; ///< otherwise its cells have the same numbers, or a few different ones
  };

  Cell                      cell = Cell::hexahedron;
  std::vector<float>        points;       ///< three coordinates each [m]
  std::vector<std::int32_t> connectivity; ///< 2, 4 or 8 points of each cell, in VTK's order
  std::vector<FloatData>    point_data;
  std::vector<FloatData>    cell_data;
  std::vector<IntegerData>  cell_numbers;

  /// The bodies whose points and cells these are, in their order, or none: makes files faster.
  std::vector<Body> bodies;
};

/// What one output of a series leaves for the next.
struct VtuPacked
{
  /// Its arrays of integers by their names, and what they were packed to: most outputs have the
  /// same.
  struct Array
  {
    std::string plain, packed;
  };
  std::map<std::string, Array> arrays;

  /// Room, so that nobody need ask the system for it again, which would hand out empty pages.
  std::string       binary;
  std::vector<char> room;
};

/// Writes @p grid at @p time [s], compressed quickly rather than well; what hardly shrinks is
/// stored as it is, and of rigid bodies and of fields that repeat, repeats are looked for where
/// they are (known_repeats.h); what deforms is stored in blocks that have parts of both.
/// @p before is used and brought up to date.
///
/// deal.II's own writer gives every cell its own copy of its vertices and stores cell data at these
/// points: for a chain that is five times the numbers and ten times the CPU time.
void write_vtu(std::ostream &out, const VtuGrid &grid, double time, VtuPacked &before);

/// Writes the file that makes one output of @p pieces, files written by write_vtu() with the same
/// fields as @p grid.
void write_pvtu(std::ostream &out, const VtuGrid &grid, const std::vector<std::string> &pieces);
} // namespace chaindrive::files
