// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace chaindrive::mesh
{
/// What a mesh file of Gmsh says, in its own numbers and lengths; nothing refers to nodes that are
/// there for sure.
struct GmshFile
{
  /// Numbers of physical groups. Elements of one entity share them: there may be many of both.
  using Groups = std::shared_ptr<const std::vector<long>>;

  struct Element
  {
    long              type = 0; ///< Gmsh's number: 3 quadrangle, 5 hexahedron of first order
    Groups            groups;   ///< that it belongs to
    std::vector<long> nodes;    ///< their numbers, in Gmsh's order
  };

  std::map<std::string, std::vector<long>> surfaces, volumes; ///< physical groups of each name
  std::map<long, dealii::Point<3>>         nodes;             ///< by their number
  std::vector<Element>                     elements;
  std::vector<std::string>                 unknown; ///< sections that the manual does not have

  /// For the end of a sentence that says what is missing: names the unknown sections, if any.
  std::string not_read() const;
};

/// Reads @p file, of version 2.2 or 4.1, ASCII or binary in any order of bytes, whole or
/// partitioned, as the chapter "File formats" of Gmsh's reference manual defines them. Version 2.2
/// lists an element once for each physical group that it belongs to; so does `elements`. A count in
/// the file is never believed before as many numbers are there. Throws InputError with the line, or
/// byte, where something else was expected.
GmshFile read_gmsh(const std::string &file);
} // namespace chaindrive::mesh
