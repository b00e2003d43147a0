// SPDX-License-Identifier: LGPL-2.1-or-later
// A pin concentric in its bore falls through the clearance c in sqrt(2 c / g) and arrives with
// sqrt(2 g c).
#include "../support/scenes.h"

using namespace test;

int main()
{
  const double c = 45e-6, g = 9.81, dt = 1e-6, radius = 2.62e-3;
  scene::Scene scene  = empty_scene();
  scene.loads.gravity = g;
  scene.bodies        = {lump(1.8e-3, Vector3()), ground()};
  scene.bores         = {{"bore",
                          scene::Interface::other,
                          {1e8, 0., 0., 0., 0.},
                          {{1, dealii::Point<3>(), radius + c, {0, dealii::Point<3>(), radius, 0}}}}};
  dynamics::System system(scene, false);
  double           time = 0., speed = 0., before = 0.;
  advance(system, 4000, dt, [&]() {
    if (time == 0. && system.contacts.families()[0]->records()[0].gap < 0.)
      {
        // back from the end of the step to the touch
        speed = before;
        time  = system.world.time + system.contacts.families()[0]->records()[0].gap / speed;
      }
    before = std::abs(system.world.frames[0].velocity[1]);
  });
  ratio("time of the fall", time, std::sqrt(2. * c / g), 4);
  ratio("speed at the touch", speed, std::sqrt(2. * g * c), 3);
}
