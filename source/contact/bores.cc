// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/family.h>

namespace chaindrive::contact
{
Bores::Bores(const scene::BoreFamily &scene) : Family(scene.name, scene.law), pairs_(scene.pairs)
{
  for (const scene::BorePair &pair : pairs_)
    {
      add_radius(pair.slave.radius);
      add_record(pair.master, pair.slave.body, pair.slave.joint);
    }
  states_.resize(records_.size());
}

void Bores::add_forces(World &world, const double dt)
{
  for (unsigned int i = 0; i < pairs_.size(); ++i)
    apply(world,
          i,
          touch_bore(pairs_[i], world.frames[pairs_[i].master], world.frames[pairs_[i].slave.body]),
          dt);
}

void Bores::add_springs(const World &world, std::vector<Spring> &springs) const
{
  for (unsigned int i = 0; i < pairs_.size(); ++i)
    {
      const Frame &master = world.frames[pairs_[i].master];
      const Frame &slave  = world.frames[pairs_[i].slave.body];
      // Closed where the slave leans now; a concentric one leans, by convention, along the x axis
      // of its own body, the direction of the chain.
      const dealii::Tensor<1, 3> z      = axis_of(master, 2);
      const dealii::Tensor<1, 3> centre = to_world(slave, pairs_[i].slave.point);
      dealii::Tensor<1, 3>       normal = to_world(master, pairs_[i].axis) - centre;
      normal -= (normal * z) * z;
      if (normal.norm() < 1e-3 * pairs_[i].radius)
        for (unsigned int d = 0; d < 3; ++d)
          normal[d] = slave.rotation[d][0];
      normal /= normal.norm();
      add_closed(world, i, normal, centre - pairs_[i].slave.radius * normal, springs);
    }
}
} // namespace chaindrive::contact
