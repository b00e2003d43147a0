// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// A fine chain over half a turn of something that turns slowly about the origin: one end is held,
// the other one carries a constant force.

#include "scenes.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace test
{
constexpr unsigned int n_on_capstan     = 31; ///< lumps on it, the bodies 0 to 30, 6 degrees apart
constexpr double       capstan_friction = 0.1, capstan_radius = 0.05, capstan_lump = 1e-4; // m

/// The chain, its lumps @p apart [m] from the surface; body n_on_capstan is to have that.
inline scene::Scene capstan(const double apart)
{
  const double       force = 10.;
  const unsigned int n     = n_on_capstan;
  const double       step = dealii::numbers::PI / (n - 1), k_bar = 1e6;
  const double       seat = capstan_radius + capstan_lump + apart;

  scene::Scene scene = empty_scene();
  scene.loads.drag   = 200.;
  for (unsigned int i = 0; i < n; ++i)
    {
      scene.bodies.push_back(
          lump(1e-4, vector(seat * std::cos(i * step), seat * std::sin(i * step))));
      if (i > 0)
        scene.bars.push_back({i - 1, i, 2. * seat * std::sin(0.5 * step), k_bar, 2.});
    }
  const unsigned int anchor = n + 1, far = n + 2;
  for (unsigned int i = 0; i < 3; ++i)
    scene.bodies.push_back(ground());
  scene.bodies[anchor].initial.position = vector(seat, -0.1);  // holds the end at angle 0
  scene.bodies[far].initial.position    = vector(-seat, -1e3); // soft and long: a constant force
  turn(scene, n, std::make_shared<functions::Ramp>(0.5, 0., 0.01));
  scene.bars.push_back({anchor, 0, 0.1, k_bar, 2.});
  scene.bars.push_back({n - 1, far, 0.5e3, force / 0.5e3, 0.});
  return scene;
}

/// What of the lumps touches the surface, and by which law.
inline std::vector<scene::SlavePoint> capstan_slaves()
{
  std::vector<scene::SlavePoint> slaves;
  for (unsigned int i = 0; i < n_on_capstan; ++i)
    slaves.push_back({i, dealii::Point<3>(), capstan_lump, 0});
  return slaves;
}
inline scene::ContactLaw capstan_law() { return {1e5, 1., capstan_friction, 1e5, 1.}; }

/// The mean tension of the end towards which the surface does not drag, over that of the other one,
/// beside that of Euler and Eytelwein, for the surface turning with @p sense; what @p then does
/// with the system.
template <typename Then>
void compare_tensions(const std::string &name,
                      scene::Scene       scene,
                      const int          sense,
                      const Then        &then)
{
  scene.shafts[0].sense = sense;
  dynamics::System system(scene, false);
  const double     dt  = 0.5 * system.critical_time_step();
  double           sum = 0., samples = 0.;
  advance(system, static_cast<unsigned long>(0.08 / dt), dt, [&]() {
    if (system.world.time > 0.05)
      {
        sum += system.bars.tension()[n_on_capstan - 1] / system.bars.tension()[n_on_capstan];
        samples += 1.;
      }
  });
  // counter-clockwise the surface drags the chain from the held end (angle 0) to the loaded one
  ratio(name,
        sense > 0 ? sum / samples : samples / sum,
        std::exp(capstan_friction * dealii::numbers::PI),
        3);
  then(system);
}
} // namespace test
