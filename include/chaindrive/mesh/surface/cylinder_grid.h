// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>

#include <deal.II/base/point.h>

#include <vector>

namespace chaindrive::mesh
{
/// The vertices of a cylindrical side of a part as a grid: rings along the axis, circumferential
/// positions around it. The axis is parallel to z.
///
/// Rollers, bushes and pins that this program meshes have the same columns at every ring and
/// equal angles between them (see uniform()); their rings need not be equidistant, since a bush
/// bore goes on through the plates. The grids of the two joints of a link are alike but for their
/// axes and vertices.
struct CylinderGrid
{
  /// Throws InputError if the side has no faces, or if its vertices are no such grid on a cylinder
  /// to a millionth of its radius.
  CylinderGrid(const Part &part, Surface side);

  unsigned int n_circumferential() const { return static_cast<unsigned int>(angles.size()); }
  unsigned int n_rings() const { return static_cast<unsigned int>(rings.size()); }

  /// Number of the vertex in the part's mesh.
  unsigned int vertex_at(const unsigned int ring, const unsigned int column) const
  {
    return vertex[ring * n_circumferential() + column];
  }

  /// Share of the exact cylinder's area [m2] that belongs to a vertex, by the trapezoidal rule in
  /// angle and z: all shares add up to 2 pi R L.
  double area(unsigned int ring, unsigned int column) const;

  /// How far inside the ends of the side a place @p z of its axis is, m; negative outside. A half
  /// part ends at its last ring only: at the first one its mirror image goes on.
  double depth(double z) const;

  /// Whether all columns are 2 pi / n_circumferential() apart to a billionth of it.
  bool uniform() const;

  bool                      half;   ///< of a half part: the first ring is at z = 0
  double                    radius; ///< m
  dealii::Point<2>          axis;   ///< x, y in the part's frame, m
  std::vector<double>       rings;  ///< z of the rings in the part's frame, ascending, m
  std::vector<double>       angles; ///< of the columns about the axis, ascending from 0 to 2 pi
  std::vector<unsigned int> vertex; ///< [ring][column]
};
} // namespace chaindrive::mesh
