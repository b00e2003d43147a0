// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_group.h>

namespace chaindrive
{
/// What turns about an axis, or slides along one (World::hubs): sprockets, arms, slides. Those that
/// are prescribed turn as the step's program says, exactly at every step, the others by their
/// moments.
class Hubs : public BodyGroup
{
public:
  void   kick(World &world, double h) override;
  void   drift(World &world, const Step &step) override;
  void   finish(World &world, const Step &step) override;
  double kinetic_energy(const World &world) const override; ///< of those that are not prescribed
};
} // namespace chaindrive
