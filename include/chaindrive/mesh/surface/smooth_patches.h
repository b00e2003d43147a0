// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/surface/coons_patch.h>

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace chaindrive::mesh
{
/// The curved patches over the quadrilaterals @p quads of @p vertices [m]: see FacetSurface.
///
/// Normals: at a regular vertex two lines of edges cross, and their tangents span the tangent
/// plane. The tangent of a line is the one of a circle through three successive vertices; of the
/// circle that ends in the vertex, the one that starts there and the one about it the median is
/// taken, so that a jump of the curvature at the vertex, which spoils only the last of the three,
/// and one at a neighbour, which spoils only one of the other two, do no harm. At irregular
/// vertices the normal is Max's mean of the facets' (J. Graphics Tools 4(2), 1999), exact for
/// spheres.
std::vector<CoonsPatch> smooth_patches(const std::vector<dealii::Point<3>>            &vertices,
                                       const std::vector<std::array<unsigned int, 4>> &quads,
                                       double crease_angle);
} // namespace chaindrive::mesh
