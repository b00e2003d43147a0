// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/newmark.h>

namespace chaindrive::dynamics
{
void first_half(World &world, const Step &step)
{
  for (const auto &group : world.groups.all())
    group->kick(world, 0.5 * step.dt);
  for (const auto &group : world.groups.all())
    group->drift(world, step);
  world.time = step.time;
}

void second_half(World &world, const Step &step)
{
  for (const auto &group : world.groups.all())
    group->kick(world, 0.5 * step.dt);
  for (const auto &group : world.groups.all())
    group->finish(world, step);
}

void accelerations(const World &world, std::vector<double> &result)
{
  result.resize(3 * world.n_bodies());
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    {
      const double inverse = world.is_nodal(b) ? 1. / world.mass[b] : world.inverse_mass[b];
      for (unsigned int d = 0; d < 3; ++d)
        result[3 * b + d] = inverse * world.force.local_element(3 * b + d);
    }
}
} // namespace chaindrive::dynamics
