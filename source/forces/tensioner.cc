// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/tensioner.h>

#include <algorithm>

namespace chaindrive
{
namespace
{
const World::Hub &hub_of_tensioner(const World &world, const unsigned int body)
{
  return *std::find_if(world.hubs.begin(), world.hubs.end(), [body](const World::Hub &hub) {
    return hub.body == body;
  });
}
} // namespace

TensionerState state_of(const scene::Tensioner &tensioner, const World &world)
{
  const World::Hub &hub    = hub_of_tensioner(world, tensioner.body);
  const double      travel = tensioner.travel + tensioner.sense * hub.angle;
  const double      speed  = tensioner.sense * hub.speed;
  return {travel, speed, tensioner.law.force(travel, speed)};
}

std::unique_ptr<ForceElement> TensionerSpring::clone() const
{
  return std::make_unique<TensionerSpring>(*this);
}

void TensionerSpring::add_forces(World &world, const double dt)
{
  const World::Hub    &hub   = hub_of_tensioner(world, scene_.body);
  const TensionerState state = state_of(scene_, world);
  const double         push  = world.symmetry.share(scene_.sense * state.force);
  World::Vector       &on    = hub.slides ? world.force : world.moment;
  for (unsigned int d = 0; d < 3; ++d)
    on.local_element(3 * scene_.body + d) += push * hub.axis[d];
  world.ledger.spring += world.symmetry.share(scene_.law.energy(state.travel));
  const double viscous = scene_.law.viscous(state.travel, state.speed);
  if (dt > 0.)
    world.ledger.spring_damping +=
        world.symmetry.share(0.5 * (viscous_ + viscous) * (state.travel - travel_));
  travel_  = state.travel;
  viscous_ = viscous;
}

void TensionerSpring::add_springs(const World &world, std::vector<Spring> &springs) const
{
  const World::Hub &hub = hub_of_tensioner(world, scene_.body);
  springs.push_back({scene_.body,
                     Spring::ground,
                     hub.axis,
                     world.frames[scene_.body].position,
                     world.frames[scene_.body].position,
                     scene_.law.stiffest(),
                     scene_.law.most_damping(),
                     !hub.slides});
}

void TensionerSpring::serialize(const Archive &archive)
{
  archive("travel", travel_);
  archive("viscous", viscous_);
}
} // namespace chaindrive
