// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/import/gmsh_file.h>
#include <chaindrive/mesh/part.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <set>
#include <string>

namespace chaindrive::mesh
{
/// The hexahedra of @p gmsh, read from @p file in mm, as a triangulation in m. Outer faces on which
/// a physical surface lies have the boundary id that @p surface_of gives its number, all others
/// other_surface; cells of the physical volumes @p hub_volumes are hub_zone, all others rim. What
/// is listed for several physical groups is there once.
///
/// Throws InputError for nodes that are not there or far away, inverted cells, cells that do not
/// share whole faces with their neighbours or are not joined to one body (joined.h), and surfaces
/// that are not on the outside.
std::unique_ptr<dealii::Triangulation<3>>
make_triangulation(const std::string             &file,
                   const GmshFile                &gmsh,
                   const std::map<long, Surface> &surface_of,
                   const std::set<long>          &hub_volumes);
} // namespace chaindrive::mesh
