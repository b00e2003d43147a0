// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/shaft.h>

#include <algorithm>
#include <stdexcept>

namespace chaindrive
{
namespace
{
const World::Hub &hub_on_shaft(const World &world, const unsigned int body)
{
  const auto found = std::find_if(
      world.hubs.begin(), world.hubs.end(), [body](const auto &hub) { return hub.body == body; });
  if (found == world.hubs.end())
    throw std::logic_error("a shaft is for bodies on mounts");
  return *found;
}
} // namespace

CouplingState state_of(const scene::Coupling &coupling, const World &world)
{
  const World::Hub &wheel   = hub_on_shaft(world, coupling.wheel),
                   &machine = hub_on_shaft(world, coupling.machine);
  // the moment on the wheel is M0 - k phi - c phi', that on the machine the opposite
  const double phi = wheel.angle - machine.angle, rate = wheel.speed - machine.speed;
  const double sense = coupling.sense;
  return {sense * (phi - coupling.torque / coupling.stiffness),
          sense * rate,
          sense * (coupling.stiffness * phi - coupling.torque),
          sense * coupling.damping * rate};
}

CouplingSpring::CouplingSpring(const scene::Scene &scene, const scene::Coupling &coupling)
    : coupling_(coupling)
    , name_("coupling of the " + scene.drive.sprockets.at(coupling.sprocket).title)
{
}

std::unique_ptr<ForceElement> CouplingSpring::clone() const
{
  return std::make_unique<CouplingSpring>(*this);
}

void CouplingSpring::add_forces(World &world, const double dt)
{
  const CouplingState state  = state_of(coupling_, world);
  const double        moment = world.symmetry.share(coupling_.sense * state.torque());
  world.moment.local_element(3 * coupling_.wheel + 2) -= moment;
  world.moment.local_element(3 * coupling_.machine + 2) += moment;
  world.ledger.spring += world.symmetry.share(0.5 * state.elastic * state.twist);
  if (dt > 0.)
    {
      const double lost = 0.5 * (viscous_ + state.viscous) * (state.twist - twist_);
      lost_ += lost;
      world.ledger.spring_damping += world.symmetry.share(lost);
    }
  twist_   = state.twist;
  viscous_ = state.viscous;
}

void CouplingSpring::add_springs(const World &world, std::vector<Spring> &springs) const
{
  springs.push_back({coupling_.wheel,
                     coupling_.machine,
                     hub_on_shaft(world, coupling_.wheel).axis,
                     world.frames[coupling_.wheel].position,
                     world.frames[coupling_.machine].position,
                     coupling_.stiffness,
                     coupling_.damping,
                     true});
}

void CouplingSpring::serialize(const Archive &archive)
{
  archive("twist", twist_);
  archive("viscous", viscous_);
  archive("lost", lost_);
}

BearingState state_of(const scene::Bearing &bearing, const World &world)
{
  BearingState state{};
  for (unsigned int d = 0; d < 2; ++d)
    {
      const World::Hub &hub = hub_on_shaft(world, bearing.bodies[d]);
      state.way[d]          = bearing.start[d] + hub.angle;
      state.speed[d]        = hub.speed;
      state.elastic[d]      = -bearing.stiffness[d] * state.way[d];
      state.viscous[d]      = -bearing.damping[d] * state.speed[d];
    }
  return state;
}

BearingSpring::BearingSpring(const scene::Scene &scene, const scene::Bearing &bearing)
    : bearing_(bearing), name_("bearing of the " + scene.drive.sprockets.at(bearing.sprocket).title)
{
}

std::unique_ptr<ForceElement> BearingSpring::clone() const
{
  return std::make_unique<BearingSpring>(*this);
}

void BearingSpring::add_forces(World &world, const double dt)
{
  const BearingState state = state_of(bearing_, world);
  for (unsigned int d = 0; d < 2; ++d)
    {
      const double weight = d == 1 ? bearing_.weight : 0.;
      world.force.local_element(3 * bearing_.bodies[d] + d) +=
          world.symmetry.share(state.force(d) + weight);
      // what bears the weight stores it as it is lowered
      world.ledger.spring += world.symmetry.share(-0.5 * state.elastic[d] * state.way[d] -
                                                  weight * (state.way[d] - bearing_.start[d]));
      if (dt > 0.)
        {
          const double lost = -0.5 * (viscous_[d] + state.viscous[d]) * (state.way[d] - way_[d]);
          lost_ += lost;
          world.ledger.spring_damping += world.symmetry.share(lost);
        }
    }
  way_     = state.way;
  viscous_ = state.viscous;
}

void BearingSpring::add_springs(const World &world, std::vector<Spring> &springs) const
{
  for (unsigned int d = 0; d < 2; ++d)
    {
      const unsigned int body = bearing_.bodies[d];
      springs.push_back({body,
                         Spring::ground,
                         hub_on_shaft(world, body).axis,
                         world.frames[body].position,
                         world.frames[body].position,
                         bearing_.stiffness[d],
                         bearing_.damping[d],
                         false});
    }
}

void BearingSpring::serialize(const Archive &archive)
{
  archive("way", way_);
  archive("viscous", viscous_);
  archive("lost", lost_);
}
} // namespace chaindrive
