// SPDX-License-Identifier: LGPL-2.1-or-later
// A fine chain over half a drum that turns slowly: the tensions of its two ends are in the ratio
// exp(mu theta) (Euler, Eytelwein). One end is held, the other carries a constant force.
#include "../support/scenes.h"

#include <chaindrive/contact/drum.h>

using namespace test;

int main()
{
  const double       mu = 0.1, radius = 0.05, force = 10.;
  const unsigned int n    = 31; // on the drum, 6 degrees apart
  const double       step = dealii::numbers::PI / (n - 1), m = 1e-4, k_contact = 1e5, k_bar = 1e6,
               r = 1e-4;

  scene::Scene scene = empty_scene();
  scene.loads.drag   = 200.;
  std::vector<scene::SlavePoint> slaves;
  const double                   seat = radius + r + 1e-12;
  for (unsigned int i = 0; i < n; ++i)
    {
      scene.bodies.push_back(lump(m, vector(seat * std::cos(i * step), seat * std::sin(i * step))));
      slaves.push_back({i, dealii::Point<3>(), r, 0});
      if (i > 0)
        scene.bars.push_back({i - 1, i, 2. * seat * std::sin(0.5 * step), k_bar, 2.});
    }
  const unsigned int drum = n, anchor = n + 1, far = n + 2;
  scene.bodies.push_back(ground());
  scene.bodies.push_back(ground());
  scene.bodies.push_back(ground());
  scene.bodies[anchor].initial.position = vector(seat, -0.1);  // holds the end at angle 0
  scene.bodies[far].initial.position    = vector(-seat, -1e3); // soft and long: a constant force
  turn(scene, drum, std::make_shared<functions::Ramp>(0.5, 0., 0.01));
  scene.bars.push_back({anchor, 0, 0.1, k_bar, 2.});
  scene.bars.push_back({n - 1, far, 0.5e3, force / 0.5e3, 0.});
  scene.surfaces.push_back(on_surface(std::make_shared<const contact::Drum>(drum, radius),
                                      {k_contact, 1., mu, k_contact, 1.},
                                      slaves));

  for (const int sense : {1, -1})
    {
      scene.shafts[0].sense = sense;
      dynamics::System system(scene, false);
      const double     dt  = 0.5 * system.critical_time_step();
      double           sum = 0., samples = 0.;
      advance(system, static_cast<unsigned long>(0.08 / dt), dt, [&]() {
        if (system.world.time > 0.05)
          {
            sum += system.bars.tension()[n - 1] / system.bars.tension()[n];
            samples += 1.;
          }
      });
      // counter-clockwise the drum drags the chain from the held end (angle 0) to the loaded one
      const double tension_ratio = sense > 0 ? sum / samples : samples / sum;
      ratio(sense > 0 ? "held over loaded end, drum turning towards the loaded end" :
                        "loaded over held end, drum turning towards the held end",
            tension_ratio,
            std::exp(mu * dealii::numbers::PI),
            3);
    }
}
