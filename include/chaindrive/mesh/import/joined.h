// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <string>

namespace chaindrive::mesh
{
/// Whether the cells of @p mesh, read from @p file, are joined to one body, so that forces pass
/// from each to its neighbours. Throws InputError if vertices lie in the places of others, within a
/// hundredth of the shortest edge, or if there are pieces that no face joins.
void check_joined(const std::string &file, const dealii::Triangulation<3> &mesh);

/// Where @p p [m] is, for a message: "(12.7, 0, 3) mm".
std::string in_mm(const dealii::Point<3> &p);
} // namespace chaindrive::mesh
