// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>

namespace chaindrive::mesh
{
/// The vertices of a hexahedron in deal.II's order, m.
using Corners = std::array<dealii::Point<3>, 8>;

Corners corners_of(const dealii::Triangulation<3>::active_cell_iterator &cell);

/// Worst corner of the hexahedron: determinant of the unit vectors along its edges, 1 for a brick,
/// not positive for an inverted cell.
double scaled_jacobian(const Corners &corners);
} // namespace chaindrive::mesh
