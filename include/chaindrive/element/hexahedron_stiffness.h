// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>
#include <chaindrive/mesh/gauss_points.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace chaindrive::element
{
/// Stiffness matrix [N/m] of the hexahedron with those points, row 3 a + i for component i of
/// vertex a. @p enhanced condenses the incompatible modes out of it: such an element bends as a
/// beam does with one layer through its thickness.
dealii::FullMatrix<double>
stiffness(const std::array<mesh::GaussPoint, 8> &points, const Material &material, bool enhanced);

/// Natural frequencies [rad/s] of the free hexahedron, ascending, six zeros among them.
/// @p stiffness as above, @p masses of the vertices [kg].
std::vector<double> natural_frequencies(const dealii::FullMatrix<double> &stiffness,
                                        const std::array<double, 8>      &masses);

/// The largest of them for a fully integrated hexahedron; @p density in kg/m3. Where it is
/// certainly below one that is @p known, 0 in a tenth of the time.
double largest_frequency(const mesh::Corners &corners,
                         const Material      &material,
                         double               density,
                         double               known = 0.);
} // namespace chaindrive::element
