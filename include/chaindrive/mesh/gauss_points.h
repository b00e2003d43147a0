// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/quality.h>

#include <array>

namespace chaindrive::mesh
{
/// What the integrals over a trilinear hexahedron need of one point of the 2 x 2 x 2 Gauss rule.
struct GaussPoint
{
  double                              volume;   ///< weight times determinant of the Jacobian, m3
  std::array<double, 8>               value;    ///< of the shape functions
  std::array<dealii::Tensor<1, 3>, 8> gradient; ///< of the shape functions, 1/m

  /// Of the incompatible modes 4 xi (1 - xi) along the three axes of the unit cell, 1/m: with the
  /// Jacobian of the cell's centre, so that their mean over the cell is zero and distorted elements
  /// pass the patch test (Taylor, Beresford and Wilson 1976).
  std::array<dealii::Tensor<1, 3>, 3> incompatible;
};

std::array<GaussPoint, 8> gauss_points(const Corners &corners);

/// Lumped masses of the vertices: row sums of the mass matrix, kg; @p density in kg/m3.
std::array<double, 8> lumped_masses(const std::array<GaussPoint, 8> &points, double density);
} // namespace chaindrive::mesh
