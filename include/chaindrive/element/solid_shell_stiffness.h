// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>
#include <chaindrive/mesh/quality.h>
#include <chaindrive/parameters/model.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

namespace chaindrive::element
{
/// Points through the thickness in which a solid-shell is integrated.
enum class ThicknessPoints
{
  one, ///< a membrane: what varies through the thickness has no stiffness
  two  ///< bends as a plate does
};

/// Strains in the order xx, yy, zz, xy, yz, zx, the last three as angles.
constexpr unsigned int n_strains = 6;

/// Their pairs of directions.
constexpr unsigned int strain_pair[n_strains][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};

struct SolidShellStiffness
{
  dealii::FullMatrix<double> stiffness;   ///< row 3 a + i for component i of vertex a, N/m
  dealii::FullMatrix<double> mean_strain; ///< over the volume: row of the strain, 1/m
};

/// A solid-shell at small displacements: a hexahedron whose nodes lie on the two faces of a wall
/// that axis @p across of the unit cell goes through. 2 x 2 points over the wall. With the
/// convected coordinates xi and eta in the wall, zeta across, and strains in their directions,
///
/// - shear xi-zeta is taken at (0, -1, 0) and (0, 1, 0), eta-zeta at (-1, 0, 0) and (1, 0, 0), and
///   is linear between (Dvorkin and Bathe 1984), so that thin walls bend without shear;
/// - thickness strain zeta-zeta is taken at the four edges (-+1, -+1, 0) and is bilinear between
///   (Betsch and Stein 1995), so that curved walls bend without being squeezed;
/// - eight strains are added that are condensed (Simo and Rifai 1990): zeta-zeta with zeta, xi
/// zeta,
///   eta zeta and xi eta zeta, so that a wall that bends gets thinner and thicker, and xi-xi with
///   xi, eta-eta with eta, xi-eta with xi and with eta, so that it bends in its own plane.
SolidShellStiffness solid_shell_stiffness(const mesh::Corners &corners,
                                          unsigned int         across,
                                          const Material      &material,
                                          ThicknessPoints      points = ThicknessPoints::two);

/// Stiffness in bending of a membrane over that of a solid-shell: what holds the normals of its
/// faces, which have no stiffness of their own.
constexpr double membrane_bending = 0.01;

/// That of a solid-shell, or of a membrane with this part of what a solid-shell has beside it.
SolidShellStiffness stiffness_of_type(const mesh::Corners    &corners,
                                      unsigned int            across,
                                      const Material         &material,
                                      parameters::ElementType element_type);

/// The axis of the unit cell that lies nearest to @p direction.
unsigned int nearest_axis(const mesh::Corners &corners, const dealii::Tensor<1, 3> &direction);

/// Hooke's law: stress xx, yy, zz, xy, yz, zx [Pa] of a unit of each strain, by Lamé's constants
/// [Pa].
dealii::FullMatrix<double> elasticity(double lambda, double mu);
} // namespace chaindrive::element
