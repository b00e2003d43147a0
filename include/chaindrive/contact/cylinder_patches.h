// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/utilities/rotation.h>

#include <deal.II/base/point.h>

#include <array>
#include <limits>

namespace chaindrive::contact
{
/// The corners [m, world], round and round, of the piece of a cylindrical side that its vertex
/// [@p ring][@p column] stands for, on a body that does not deform in the @p frame: half way to its
/// neighbours, or to the end of the side; no farther along the axis than to these @p ends.
std::array<dealii::Point<3>, 4> corners_of_piece(const mesh::CylinderGrid    &grid,
                                                 unsigned int                 ring,
                                                 unsigned int                 column,
                                                 const Frame                 &frame,
                                                 const std::array<double, 2> &ends = {
                                                     {-std::numeric_limits<double>::infinity(),
                                                      std::numeric_limits<double>::infinity()}});
} // namespace chaindrive::contact
