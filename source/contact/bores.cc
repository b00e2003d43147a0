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
  const Mobility mobility(world);
  for (unsigned int i = 0; i < pairs_.size(); ++i)
    {
      const Frame               &slave = world.frames[pairs_[i].slave.body];
      const dealii::Tensor<1, 3> z     = axis_of(world.frames[pairs_[i].master], 2);
      // along the chain, since most of the force is
      dealii::Tensor<1, 3> along = axis_of(slave, 0);
      along -= (along * z) * z;
      add_closed(world,
                 mobility,
                 i,
                 along / along.norm(),
                 to_world(slave, pairs_[i].slave.point),
                 pairs_[i].slave.radius,
                 springs);
    }
}
} // namespace chaindrive::contact
