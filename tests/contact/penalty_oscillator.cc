// SPDX-License-Identifier: LGPL-2.1-or-later
// A mass that rests on a penalty spring oscillates about m g / k below the surface with the period
// 2 pi sqrt(m / k); central differences shorten it by asin(r/2)/(r/2), r = w dt.
#include "../support/scenes.h"

using namespace test;

int main()
{
  const double m = 0.01, k = 1e5, g = 9.81, r = 1e-3;
  const double w = std::sqrt(k / m);
  for (const double share : {0.05, 0.5, 1.5}) // w dt
    {
      scene::Scene scene  = empty_scene();
      scene.loads.gravity = g;
      scene.bodies        = {lump(m, vector(0., r - 0.9e-9)), ground()};
      scene.surfaces.push_back(on_surface(
          plane(1, vector(0., 1.)), {k, 0., 0., 0., 0.}, {{0, dealii::Point<3>(), r, 0}}));
      dynamics::System system(scene, false);
      const double     dt = share / w, rest = r - m * g / k;
      double           first = 0., last = 0., before = system.world.frames[0].position[1] - rest;
      unsigned int     crossings = 0;
      advance(system, static_cast<unsigned long>(200. / share), dt, [&]() {
        const double now = system.world.frames[0].position[1] - rest;
        if (before < 0. && now >= 0.)
          {
            last = system.world.time - dt * now / (now - before);
            if (crossings++ == 0)
              first = last;
          }
        before = now;
      });
      const double period = (last - first) / (crossings - 1);
      const double exact  = 2. * dealii::numbers::PI / w;
      std::cout << "w dt = " << share << '\n';
      ratio("  period", period, exact * 0.5 * share / std::asin(0.5 * share), 4);
      // the balance wavers with (w dt)^2 of the energy that swings to and fro
      const double swings = 0.5 * m * g * m * g / k;
      verdict("  energy balance within (w dt)^2 of the energy that swings",
              std::abs(system.world.ledger.imbalance()) < share * share * swings);
    }
}
