// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/scene/drive_view.h>

namespace chaindrive::observe
{
/// Where the middle of the roller of @p joint is [m], or of the bush in its place, also without
/// Services::update_bodies().
inline dealii::Tensor<1, 3>
roller_position(const scene::DriveView &drive, const World &world, const unsigned int joint)
{
  const unsigned int body = drive.rollers[joint];
  return drive.bushes.empty() ? world.position_of(body) :
                                world.position_of(body, drive.bushes[joint]);
}

/// How fast it moves, m/s.
inline dealii::Tensor<1, 3>
roller_velocity(const scene::DriveView &drive, const World &world, const unsigned int joint)
{
  const unsigned int body = drive.rollers[joint];
  return drive.bushes.empty() ? world.velocity_of(body) :
                                world.velocity_of(body, drive.bushes[joint]);
}
} // namespace chaindrive::observe
