// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/elastic_group.h>
#include <chaindrive/contact/closed_pair.h>
#include <chaindrive/scene/contact_law.h>

#include <deal.II/lac/full_matrix.h>

#include <map>

namespace chaindrive::stability
{
using Matrix = dealii::FullMatrix<double>;

constexpr unsigned int n_directions = 16; ///< about which a round side may touch

/// The largest eigenvalue of a symmetric matrix without negative ones.
double largest(const Matrix &matrix);

/// What the springs of a @p side of @p modal bodies add to
/// ModalGroup::modal_matrix(), 1/s2. They act along the normals of the side and, with friction,
/// across. Of a round side that touches in part, that part, about the worst of n_directions.
Matrix added_to_modes(const ModalGroup          &bodies,
                      const contact::ClosedSide &side,
                      const scene::ContactLaw   &law);

/// Modal bodies with springs on their sides.
struct ModalBodies
{
  /// One side.
  struct Side
  {
    Matrix springs;                      ///< see added_to_modes()
    double stiffness = 0., damping = 0.; ///< times these springs, 1 and s

    /// Of several kinds of contact that the side may have the one with the largest factor counts.
    void update_largest(const Matrix &of_kind, double factor, double time);
  };

  Matrix                       free;  ///< without springs
  std::map<unsigned int, Side> sides; ///< by surface

  /// The largest of free + sum (stiffness + 2 damping / @p dt) springs, 1/s2: that of a step of dt
  /// with dampers at the velocities of half a step before, see critical_time_step.h.
  double eigenvalue(double dt) const;

  /// The largest dt [s] with dt^2 eigenvalue(dt) <= 4.
  double critical_time_step() const;
};
} // namespace chaindrive::stability
