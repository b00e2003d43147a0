// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/quality.h>
#include <chaindrive/parameters/model.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

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

/// Stiffness matrix [N/m] of the hexahedron with those points, row 3 a + i for component i of
/// vertex a. @p enhanced condenses the incompatible modes out of it: such an element bends as a
/// beam does with one layer through its thickness.
dealii::FullMatrix<double> stiffness(const std::array<GaussPoint, 8> &points,
                                     const parameters::Material      &material,
                                     bool                             enhanced);

/// Lumped masses of the vertices: row sums of the mass matrix, kg; @p density in kg/m3.
std::array<double, 8> lumped_masses(const std::array<GaussPoint, 8> &points, double density);

/// Natural frequencies [rad/s] of the free hexahedron, ascending, six zeros among them.
/// @p stiffness as above, @p masses of the vertices [kg].
std::vector<double> natural_frequencies(const dealii::FullMatrix<double> &stiffness,
                                        const std::array<double, 8>      &masses);

/// The largest of them for a fully integrated hexahedron; @p density in kg/m3.
double
largest_frequency(const Corners &corners, const parameters::Material &material, double density);
} // namespace chaindrive::mesh
