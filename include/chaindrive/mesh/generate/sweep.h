// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>

#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace chaindrive::mesh
{
/// A mesh of quadrilaterals in the plane: the cross-section from which a part is swept along z.
struct PlanarMesh
{
  struct Quad
  {
    std::array<unsigned int, 4> vertices; ///< counter-clockwise
    Component                   component;
  };

  std::vector<dealii::Point<2>> points; ///< m
  std::vector<Quad>             quads;

  /// Appends @p p and returns its number.
  unsigned int add(const dealii::Point<2> &p);

  /// Appends the quadrilaterals of a grid of point numbers: rows[j][i] and rows[j + 1][i] are
  /// neighbours; i runs along the first side and j must lie to its left. @p closed joins the last
  /// column to the first.
  void
  add_grid(const std::vector<std::vector<unsigned int>> &rows, Component component, bool closed);
};

/// Values that divide the interval from @p first to @p last into @p n equal parts, both included.
std::vector<double> divide(double first, double last, unsigned int n);

/// Planes that divide a body from z = - @p outer_face to + @p outer_face into @p n layers, n even;
/// or those of its @p half at z >= 0.
std::vector<double> planes_of(double outer_face, unsigned int n, bool half);

using Line = std::vector<dealii::Point<2>>;
using Grid = std::vector<Line>; ///< [row][column]

/// Fractions of the length along @p line, of each of its points.
std::vector<double> fractions_along(const Line &line);

/// Transfinite interpolation (Gordon and Hall 1973) between the first and last rows and the first
/// and last columns of a grid, which share their corners.
Grid fill(const Line &first_row,
          const Line &last_row,
          const Line &first_column,
          const Line &last_column);

/// Sweeps @p section through the planes z = @p planes [m, ascending]. A quadrilateral becomes a
/// cell in the layer between planes k and k + 1 if @p present (component, k) says so. Cells are
/// numbered quadrilateral by quadrilateral, layer by layer, and keep the quadrilaterals' vertex
/// order.
/// @p surface_of gives the boundary id of a boundary face from its component, its centre and
/// whether it is an end face, that is, normal to z.
std::unique_ptr<dealii::Triangulation<3>> sweep(
    const PlanarMesh                                                   &section,
    const std::vector<double>                                          &planes,
    const std::function<bool(Component component, unsigned int layer)> &present,
    const std::function<Surface(Component component, const dealii::Point<3> &centre, bool end_face)>
        &surface_of);
} // namespace chaindrive::mesh
