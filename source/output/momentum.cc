// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/output/momentum.h>

#include <algorithm>

namespace chaindrive::output
{
MomentumBalance::MomentumBalance(const dynamics::System &system)
    : kept_(system.world.rims.empty()), free_(system.world.n_bodies(), 1)
{
  for (const World::Hub &hub : system.world.hubs)
    free_[hub.body] = 0;
  start_ = momentum(system, moved_);
  force_ = external_force(system);
}

dealii::Tensor<1, 3> MomentumBalance::momentum(const dynamics::System &system, double &moved) const
{
  const World         &world = system.world;
  dealii::Tensor<1, 3> sum;
  moved = 0.;
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (free_[b])
      {
        sum += world.mass[b] * world.frames[b].velocity;
        moved += world.mass[b] * world.frames[b].velocity.norm();
      }
  return sum;
}

dealii::Tensor<1, 3> MomentumBalance::external_force(const dynamics::System &system) const
{
  const World         &world = system.world;
  dealii::Tensor<1, 3> sum;
  for (const World::Hub &hub : world.hubs)
    for (unsigned int d = 0; d < 3; ++d)
      sum[d] -= world.force.local_element(3 * hub.body + d);
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (free_[b])
      {
        sum[1] -= world.mass[b] * system.loads.gravity();
        sum -= system.loads.drag() * world.mass[b] * world.frames[b].velocity;
      }
  return sum;
}

void MomentumBalance::add_step(const dynamics::System &system, const double dt)
{
  if (!kept_)
    return;
  const dealii::Tensor<1, 3> now = external_force(system);
  impulse_ += 0.5 * dt * (force_ + now);
  force_ = now;
}

void MomentumBalance::check(const dynamics::System &system)
{
  if (!kept_)
    return;
  double                     moved = 0.;
  const dealii::Tensor<1, 3> error = momentum(system, moved) - start_ - impulse_;
  largest_                         = std::max(largest_, error.norm());
  moved_                           = std::max(moved_, moved);
}
} // namespace chaindrive::output
