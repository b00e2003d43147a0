// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/statics/cache.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace chaindrive::reduction
{
/// A cylindrical side of a part in patches: as many columns about its axis as its mesh has, column
/// c at the angle 2 pi c / n_columns, times rings along it. Patches of a column follow each other,
/// ring by ring, and columns do. A force on a patch is shared out to the nodes of its column as an
/// even pressure along the ring is, consistently with what its elements interpolate, and its
/// displacement is the mean along the ring.
struct SidePatches
{
  /// The @p surface of @p part with rings between the @p bounds [m], ascending. InputError if
  /// the side is no grid with equal angles from the x axis on, or if there is no side in a ring.
  SidePatches(const mesh::Part          &part,
              const mesh::Nodes         &nodes,
              mesh::Surface              surface,
              const std::vector<double> &bounds);

  /// The same with a ring of patches for each of its rows of nodes: a patch is a node.
  SidePatches(const mesh::Part &part, const mesh::Nodes &nodes, mesh::Surface surface);

  mesh::Surface                    surface;
  double                           radius; ///< m
  dealii::Point<2>                 axis;   ///< in the part's frame, m
  unsigned int                     n_columns;
  std::vector<double>              bounds; ///< of rings, m
  std::vector<double>              height; ///< z of the middle of the nodes' shares, m
  std::vector<double>              length; ///< along the axis of what carries a ring, m
  std::vector<std::vector<double>> share;  ///< [ring][row], all rows of a ring: 1
  std::vector<unsigned int>        node;   ///< [row][column], rows of nodes about the axis

  unsigned int n_rings() const { return static_cast<unsigned int>(height.size()); }
  unsigned int n() const { return n_columns * n_rings(); }
  double       angle(unsigned int column) const;

  /// Area of a patch, m2.
  double area(const unsigned int ring) const
  {
    return 2. * dealii::numbers::PI / n_columns * radius * length[ring];
  }

  /// A force of one newton away from the axis on a patch, of a part with @p n_unknowns.
  Vector force(unsigned int column, unsigned int ring, unsigned int n_unknowns) const;

  /// The mean displacement @p u of a patch away from the axis.
  double displacement(const Vector &u, unsigned int column, unsigned int ring) const;
};

/// How the sides of a free part deflect: the displacement of each patch away from its axis,
/// relative to the motion of the part as a rigid body, by a force of one newton on each other one,
/// m/N. Sides come one after the other. This is the sum of phi phi^T / omega^2 over all elastic
/// modes.
using SideFlexibility = dealii::FullMatrix<double>;

/// Of @p sides of @p part, from one solution for each patch that is no mirror image of another one;
/// of a part whose sides are all about its z axis, which is taken to be round, for each of one
/// column.
SideFlexibility side_flexibility(const FreePart &part, const std::vector<SidePatches> &sides);

/// The same from the @p cache if it is there: the same bit by bit on all ranks of @p comm, whose
/// first one, which alone needs @p part, computes it and reads and writes the cache. Collective.
SideFlexibility kept_side_flexibility(const std::function<const FreePart &()> &part,
                                      const std::vector<SidePatches>          &sides,
                                      statics::Cache                          &cache,
                                      MPI_Comm                                 comm);

/// What each of @p motions displaces patches away from their axes, [patch][motion]; of modes and
/// rigid motions of unit mass, 1/sqrt(kg).
dealii::FullMatrix<double> patch_motions(const std::vector<SidePatches> &sides,
                                         const std::vector<Vector>      &motions);

/// The part of a @p flexibility that a basis lacks: C - sum of phi phi^T / omega^2 over its modes,
/// whose displacements of the patches are @p modes. It is positive semidefinite if the modes are of
/// the same mesh, since they are orthogonal with respect to its stiffness.
SideFlexibility residual_flexibility(const SideFlexibility            &flexibility,
                                     const dealii::FullMatrix<double> &modes,
                                     const std::vector<double>        &omega);

/// The highest angular frequency [rad/s] of a part some of whose patches, @p closed, are held by
/// rigid bodies without mass: omega^2 is the largest eigenvalue of
///
///   W^2 + N^T C^-1 N
///
/// with the natural frequencies W of @p omega, N the displacements of these patches by rigid
/// motions
/// (@p rigid, of unit mass) and modes (@p modes), and C what the @p residual flexibility says of
/// them. It grows with every patch that closes, since C^-1 of more patches less that of fewer is a
/// Schur complement, and is the same for any signs that sides are seen with. No system of bodies
/// that press each other has a higher frequency than the highest one of its parts held in this way:
/// of the deflections that close all gaps, one returns the patches of every body to where they
/// were, and the energy is the least of all (doc/theory.md, section 3). Central differences are
/// stable up to a step of 2 / omega.
double closed_frequency(const std::vector<double>        &omega,
                        const dealii::FullMatrix<double> &rigid,
                        const dealii::FullMatrix<double> &modes,
                        const SideFlexibility            &residual,
                        const std::vector<unsigned int>  &closed);
} // namespace chaindrive::reduction
