// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>

#include <vector>

namespace chaindrive
{
/// How easily the bodies of a world are moved by forces and moments.
class Mobility
{
public:
  explicit Mobility(const World &world);

  /// Inverse inertia tensor of @p body about its centre of mass (a hub's: about its axis) in world
  /// axes, 1/(kg m2); zero where it cannot turn.
  const dealii::Tensor<2, 3> &inverse_inertia(const unsigned int body) const
  {
    return inverse_inertia_[body];
  }

  /// About what @p body turns: its centre of mass or its axis, m.
  const dealii::Tensor<1, 3> &centre(const unsigned int body) const { return pivot_[body]; }

  /// Makes of the @p force [N] and the @p moment [N m] about its centre on each body the
  /// accelerations [m/s2] of that centre and [rad/s2] that they cause.
  void accelerate(std::vector<dealii::Tensor<1, 3>> &force,
                  std::vector<dealii::Tensor<1, 3>> &moment) const;

  /// Acceleration per force of the material point of @p body that is at @p at [world, m], 1/kg.
  dealii::Tensor<2, 3> of_point(unsigned int body, const dealii::Tensor<1, 3> &at) const;

private:
  /// The force on the second body of the line of @p tied under a unit moment, 1/m.
  dealii::Tensor<1, 3> lever_of(const World::Tied &tied) const;

  const World                      &world_;
  std::vector<dealii::Tensor<2, 3>> inverse_inertia_;
  std::vector<dealii::Tensor<1, 3>> pivot_; ///< about what a body turns: centre of mass or axis, m
};
} // namespace chaindrive
