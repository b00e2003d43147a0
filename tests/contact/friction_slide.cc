// SPDX-License-Identifier: LGPL-2.1-or-later
// A block slides over a plane until Coulomb friction stops it: s = v^2/(2 mu g), t = v/(mu g).
// Then it stands still: on a plane that truly sticks it does not creep.
#include "../support/scenes.h"

using namespace test;

int main()
{
  for (const double mu : {0.1, 0.2})
    {
      scene::Scene scene  = empty_scene();
      scene.loads.gravity = 9.81;
      const double m = 1., k = 1e6, r = 0.01, v = 0.2;
      const double sunk = m * 9.81 / k; // starts in equilibrium on its spring
      scene.bodies      = {lump(m, vector(0., r - 0.999e-9), vector(v, 0.)), ground()};
      scene.surfaces.push_back(on_surface(plane(1, vector(0., 1.)),
                                          {k, 2. * 0.5 * std::sqrt(k * m), mu, 0.8 * k, 800.},
                                          {{0, dealii::Point<3>(), r, 0}}));
      dynamics::System system(scene, false);
      double           stop_time = 0.;
      const double     dt        = 1e-5;
      advance(system, 30000, dt, [&]() {
        if (stop_time == 0. && system.world.velocity.local_element(0) <= 0.)
          stop_time = system.world.time;
      });
      const double distance = system.world.displacement.local_element(0);
      std::cout << "mu = " << mu << '\n';
      ratio("stopping distance", distance, v * v / (2. * mu * 9.81), 4);
      ratio("stopping time", stop_time, v / (mu * 9.81), 3);
      ratio("friction loss", system.world.ledger.friction, 0.5 * m * v * v, 4);
      const double before = system.world.displacement.local_element(0);
      advance(system, 20000, dt, []() {});
      verdict("creep in 0.2 s below 1e-12 m",
              std::abs(system.world.displacement.local_element(0) - before) < 1e-12);
      verdict("sunk in by m g / k to 1e-6",
              std::abs((r - system.world.frames[0].position[1]) / sunk - 1.) < 1e-6);
    }
}
