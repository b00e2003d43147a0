// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/hubs.h>
#include <chaindrive/bodies/world.h>

namespace chaindrive
{
void Hubs::kick(World &world, const double h)
{
  for (World::Hub &hub : world.hubs)
    if (!hub.prescribed)
      hub.speed += h / hub.inertia * world.moment_about(hub);
}

void Hubs::drift(World &world, const Step &step)
{
  for (std::size_t i = 0; i < world.hubs.size(); ++i)
    {
      World::Hub &hub = world.hubs[i];
      if (hub.prescribed && step.programs != nullptr)
        {
          hub.angle = step.programs[i].angle;
          hub.speed = step.programs[i].mean_speed;
        }
      else
        hub.angle += step.dt * hub.speed;
      world.place(hub);
    }
  world.place_carried();
}

void Hubs::finish(World &world, const Step &step)
{
  for (std::size_t i = 0; i < world.hubs.size(); ++i)
    {
      World::Hub &hub = world.hubs[i];
      if (hub.prescribed && step.programs != nullptr)
        hub.speed = step.programs[i].speed;
      world.place(hub);
    }
  world.place_carried();
}

double Hubs::kinetic_energy(const World &world) const
{
  double energy = 0.;
  for (const World::Hub &hub : world.hubs)
    if (!hub.prescribed)
      energy += 0.5 * hub.inertia * hub.speed * hub.speed;
  return energy;
}
} // namespace chaindrive
