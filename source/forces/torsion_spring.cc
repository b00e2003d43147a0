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

void add_moment(World                      &world,
                const unsigned int          first,
                const unsigned int          second,
                const dealii::Tensor<1, 3> &moment)
{
  for (unsigned int d = 0; d < 3; ++d)
    {
      world.moment.local_element(3 * first + d) += world.symmetry.share(moment[d]);
      world.moment.local_element(3 * second + d) -= world.symmetry.share(moment[d]);
    }
}

void add_spring(const World         &world,
                const unsigned int   first,
                const unsigned int   second,
                const double         stiffness,
                const double         damping,
                std::vector<Spring> &springs)
{
  springs.push_back({first,
                     second,
                     hub_of(world, first).axis,
                     world.frames[first].position,
                     world.frames[second].position,
                     stiffness,
                     damping,
                     true});
}
} // namespace

std::unique_ptr<ForceElement> TorsionSpring::clone() const
{
  return std::make_unique<TorsionSpring>(*this);
}

// The potential energy k phi^2 / 2 - M0 phi is zero at the start.
void TorsionSpring::add_forces(World &world, const double dt)
{
  const auto [axis, angle, speed] = relative(world, first, second);
  const double viscous            = damping * speed;
  add_moment(world, first, second, (preload - stiffness * angle - viscous) * axis);
  world.ledger.spring += world.symmetry.share((0.5 * stiffness * angle - preload) * angle);
  if (dt > 0.)
    world.ledger.spring_damping +=
        world.symmetry.share(0.5 * (viscous_ + viscous) * (angle - angle_));
  angle_   = angle;
  viscous_ = viscous;
}

void TorsionSpring::add_springs(const World &world, std::vector<Spring> &springs) const
{
  add_spring(world, first, second, stiffness, damping, springs);
}

void TorsionSpring::serialize(const Archive &archive)
{
  archive("angle", angle_);
  archive("viscous", viscous_);
}

std::unique_ptr<ForceElement> Stop::clone() const { return std::make_unique<Stop>(*this); }

void Stop::add_forces(World &world, const double dt)
{
  const auto [axis, angle, speed] = relative(world, first, second);
  const double beyond             = std::max(0., sign * (angle - from));
  const double elastic            = stiffness * beyond;
  // as it lets go the dashpot would pull
  const double viscous = beyond > 0. ? std::max(damping * sign * speed, -elastic) : 0.;
  add_moment(world, first, second, -sign * (elastic + viscous) * axis);
  world.ledger.spring += world.symmetry.share(0.5 * elastic * beyond);
  if (dt > 0.)
    world.ledger.spring_damping +=
        world.symmetry.share(0.5 * (viscous_ + viscous) * sign * (angle - angle_));
  angle_   = angle;
  viscous_ = viscous;
}

void Stop::add_springs(const World &world, std::vector<Spring> &springs) const
{
  add_spring(world, first, second, stiffness, damping, springs);
}

void Stop::serialize(const Archive &archive)
{
  archive("angle", angle_);
  archive("viscous", viscous_);
}
} // namespace chaindrive
