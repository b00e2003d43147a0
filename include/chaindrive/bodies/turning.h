// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/pack.h>

namespace chaindrive
{
/// How n_lanes bodies turn about their centres of mass: [...][lane].
struct alignas(64) Turning
{
  double momentum[3][n_lanes];    ///< angular, world axes, kg m2/s
  double inertia[3][n_lanes];     ///< principal moments in body axes, kg m2
  double orientation[4][n_lanes]; ///< unit quaternion, w first
  double rotation[9][n_lanes];    ///< the same as a matrix, row by row: body axes to world axes

  double angular_velocity[3][n_lanes]; ///< world axes, rad/s
};

/// The angular velocity w = R I^-1 R^T L where the bodies are.
void find_angular_velocity(Turning &bodies);

/// Turns them on by the time @p dt [s], with the momentum half of it later (doc/theory.md, section
/// 5): the explicit midpoint rule, whose angular velocity this sets. Rotation vectors have less
/// than most_turned: returns false, and the bodies are to be turned by rotation_by(), where one has
/// more.
bool turn(Turning &bodies, double dt);

constexpr double most_turned = 1e-3; ///< rad, in half a step as in a whole one
} // namespace chaindrive
