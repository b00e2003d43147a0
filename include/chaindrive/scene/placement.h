// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/mirror_symmetry.h>
#include <chaindrive/utilities/rotation.h>

#include <deal.II/base/point.h>

#include <cmath>
#include <vector>

namespace chaindrive::scene
{
using Tensor3 = dealii::Tensor<1, 3>;

/// The frame of a body in the drive plane: at @p at [m], turned by @p angle [rad] about z, moving
/// with @p velocity [m/s] and turning with @p speed [rad/s].
inline Frame placed(const dealii::Point<2>     &at,
                    const double                angle,
                    const dealii::Tensor<1, 2> &velocity,
                    const double                speed)
{
  Frame frame;
  frame.rotation = to_matrix(rotation_about_z(angle));
  for (unsigned int d = 0; d < 2; ++d)
    {
      frame.position[d] = at[d];
      frame.velocity[d] = velocity[d];
    }
  frame.angular_velocity[2] = speed;
  return frame;
}

/// The two axial positions [m] at which half of a line contact of @p length [m] acts, each: the
/// points of Gauss' rule, so that the second moment of the line is kept. With @p half set, that
/// above the middle plane: World::sum_over_ranks() adds its image's force.
inline std::vector<double> axial_positions(const double length, const bool half)
{
  return MirrorSymmetry(half).axial_positions(length / (2. * std::sqrt(3.)));
}
} // namespace chaindrive::scene
