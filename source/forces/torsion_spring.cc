// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/torsion_spring.h>

#include <algorithm>
#include <stdexcept>

namespace chaindrive
{
namespace
{
const World::Hub &hub_of(const World &world, const unsigned int body)
{
  for (const World::Hub &hub : world.hubs)
    if (hub.body == body)
      return hub;
  throw std::logic_error("a torsion spring is for bodies on mounts");
}

/// Angle and speed of the first body relative to the second, about the axis of the first.
struct Relative
{
  dealii::Tensor<1, 3> axis;
  double               angle, speed;
};

Relative relative(const World &world, const unsigned int first, const unsigned int second)
{
  const World::Hub &one = hub_of(world, first), &other = hub_of(world, second);
  const double      same = one.axis * other.axis;
  return {one.axis, one.angle - same * other.angle, one.speed - same * other.speed};
}

} // namespace

void RotaryElement::add_forces(World &world, const double dt)
{
  const auto [axis, angle, speed]       = relative(world, first_, second_);
  const auto [elastic, viscous, energy] = action(angle, speed);
  const double moment                   = world.symmetry.share(elastic - viscous);
  for (unsigned int d = 0; d < 3; ++d)
    {
      world.moment.local_element(3 * first_ + d) += moment * axis[d];
      world.moment.local_element(3 * second_ + d) -= moment * axis[d];
    }
  world.ledger.spring += world.symmetry.share(energy);
  if (dt > 0.)
    world.ledger.spring_damping +=
        world.symmetry.share(0.5 * (viscous_ + viscous) * (angle - angle_));
  angle_   = angle;
  viscous_ = viscous;
}

void RotaryElement::add_springs(const World &world, std::vector<Spring> &springs) const
{
  springs.push_back({first_,
                     second_,
                     hub_of(world, first_).axis,
                     world.frames[first_].position,
                     world.frames[second_].position,
                     stiffness_,
                     damping_,
                     true});
}

void RotaryElement::serialize(const Archive &archive)
{
  archive("angle", angle_);
  archive("viscous", viscous_);
}

std::unique_ptr<ForceElement> TorsionSpring::clone() const
{
  return std::make_unique<TorsionSpring>(*this);
}

// The potential energy k phi^2 / 2 - M0 phi is zero at the start.
RotaryElement::Action TorsionSpring::action(const double angle, const double speed) const
{
  return {preload_ - stiffness_ * angle,
          damping_ * speed,
          (0.5 * stiffness_ * angle - preload_) * angle};
}

std::unique_ptr<ForceElement> Stop::clone() const { return std::make_unique<Stop>(*this); }

RotaryElement::Action Stop::action(const double angle, const double speed) const
{
  const double beyond  = std::max(0., sign_ * (angle - from_));
  const double elastic = stiffness_ * beyond;
  // as it lets go the dashpot would pull
  const double viscous = beyond > 0. ? std::max(damping_ * sign_ * speed, -elastic) : 0.;
  return {-sign_ * elastic, sign_ * viscous, 0.5 * elastic * beyond};
}
} // namespace chaindrive
