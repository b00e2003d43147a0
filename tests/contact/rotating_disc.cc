// SPDX-License-Identifier: LGPL-2.1-or-later
// A block on a disc that is slowly spun up slips when w^2 r = mu g. The weight is the pull of a
// very long, soft bar along the disc's axis.
#include "../support/scenes.h"

using namespace test;

int main()
{
  for (const double mu : {0.1, 0.2})
    {
      const double m = 0.1, k = 1e6, g = 9.81, r = 0.05, full = 8., ramp = 16.;
      scene::Scene scene = empty_scene();
      turn(scene, 1, std::make_shared<functions::Ramp>(full, 0., ramp));
      const double sunk = m * g / k;
      scene.bodies      = {lump(m, vector(r, 0., 1e-3 - 0.9e-9)), ground(), ground()};
      scene.bodies[2].initial.position = vector(r, 0., -1000.);
      scene.bars                       = {{0, 2, 999., m * g / 1.001, 0.}};
      scene.surfaces.push_back(on_surface(plane(1, vector(0., 0., 1.)),
                                          {k, 300., mu, k, 300.},
                                          {{0, dealii::Point<3>(), 1e-3, 0}}));
      dynamics::System system(scene, false);
      double           slip_speed = 0., depth = 0.;
      bool             stuck    = true;
      const double     dt       = 1e-4; // s; the disc gains 0.5 rad/s each second
      const double     expected = std::sqrt(mu * g / r);
      advance(system, 150000, dt, [&]() {
        const double distance =
            std::hypot(system.world.frames[0].position[0], system.world.frames[0].position[1]);
        if (system.world.hubs[0].speed < 0.99 * expected)
          {
            stuck = stuck && std::abs(distance - r) < 0.2e-6;
            depth = 1e-3 - system.world.frames[0].position[2];
          }
        if (slip_speed == 0. && distance > r + 1e-6)
          slip_speed = system.world.hubs[0].speed;
      });
      verdict("stuck to the disc within 0.2 um until then", stuck);
      std::cout << "mu = " << mu << ", slips at " << std::setprecision(3) << slip_speed
                << " rad/s\n";
      ratio("  which is", slip_speed, expected, 3);
      ratio("  sunk in until then", depth, sunk, 3);
    }
}
