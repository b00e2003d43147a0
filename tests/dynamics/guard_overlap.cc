// SPDX-License-Identifier: LGPL-2.1-or-later
// A body runs into a wall whose contact is too soft to hold it: v sqrt(m/k) is as far as it gets.
// What goes beyond a quarter of its radius is stopped, what stays below is not. So is a contact
// that feeds energy, though the ledger closes.
#include "../support/scenes.h"

#include <chaindrive/dynamics/guard.h>

using namespace test;

namespace
{
scene::Scene impact(const double radius, const double mass, const double speed, const double depth)
{
  scene::Scene scene = empty_scene();
  scene.bodies       = {lump(mass, vector(-2. * radius, 0., 0.), vector(speed, 0.)), ground()};
  scene::ContactLaw law;
  law.stiffness  = mass * speed * speed / (depth * depth);
  scene.surfaces = {
      on_surface(plane(1, vector(-1., 0.)), law, {{0, dealii::Point<3>(), radius, 0}})};
  return scene;
}

/// Steps until the guard stops @p scene, 0 if it does not; what it says.
unsigned int stopped_at(const scene::Scene &scene, const unsigned int n, std::string &message)
{
  dynamics::System system(scene, false);
  // of the spring alone: a dashpot that feeds energy has no critical time step
  const double       limit = 2. * std::sqrt(scene.bodies[0].mass / scene.surfaces[0].law.stiffness);
  const double       dt    = 0.01 * limit;
  dynamics::Guard    guard(scene, system, 0.05, limit);
  dynamics::Services services(system);
  for (unsigned int i = 1; i <= n; ++i)
    try
      {
        system.advance(dt, i * dt);
        guard.observe(system, i, dt, services);
      }
    catch (const dynamics::Fault &fault)
      {
        message = fault.what();
        return i;
      }
  return 0;
}
} // namespace

int main()
{
  const double radius = 5e-3, mass = 0.01, speed = 2.;
  for (const double part : {0.2, 0.24, 0.26, 0.3, 2.})
    {
      std::string        message;
      const unsigned int step =
          stopped_at(impact(radius, mass, speed, part * radius), 2000, message);
      std::cout << part << " of the radius: " << (step > 0 ? "stopped" : "goes on") << '\n';
      if (step > 0)
        verdict("  names the interface and the body",
                message.find("interface surface at joint 0 (roller 0") != std::string::npos);
    }

  // the balance closes, since what it gives is booked
  scene::Scene feeds            = impact(radius, mass, speed, 0.1 * radius);
  feeds.surfaces[0].law.damping = -0.2 * std::sqrt(feeds.surfaces[0].law.stiffness * mass);
  std::string message;
  stopped_at(feeds, 2000, message);
  verdict("a contact that feeds energy: stopped, and the message says so",
          message.find("lost falls by") != std::string::npos);
}
