// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// How far beyond the limit of the critical time step closed contacts become unstable.

#include "reduced.h"

#include <random>

namespace test
{
/// The smallest of the tried shares of the limit, up to a @p last one, with which the disturbed
/// vibration of @p scene grows a thousandfold, 2 if none. Before, @p settling steps bring it to
/// rest; with the first share it makes @p steps, with others 1000.
inline double blow_up(const scene::Scene &scene,
                      const unsigned long settling,
                      const unsigned long steps,
                      const double        last = 2.)
{
  dynamics::System                       system(scene, false);
  const double                           limit = system.critical_time_step();
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> uniform(-1e-3, 1e-3); // m/s
  advance(system, settling, 0.8 * limit, []() {});
  const double at_rest = system.world.ledger.kinetic;
  double       first   = 0.; // energy of the disturbance
  for (double share = 0.98; share < last; share += 0.02)
    {
      for (const auto &group : system.world.groups.all())
        if (auto *reduced = dynamic_cast<ReducedBodies *>(group))
          for (unsigned int m = 0; m < reduced->n_modes(); ++m)
            reduced->rate(system.world, 0, m) += 1e-2 * uniform(random); // m/s sqrt(kg)
      for (BodyBatches &copies : system.world.copies)
        for (unsigned int i = 0; i < copies.velocity.locally_owned_size(); i += n_lanes)
          copies.velocity.local_element(i) += uniform(random); // of the first lane, the body
      double largest = 0.;
      advance(system, share < 0.99 ? steps : 1000, share * limit, [&]() {
        const double kinetic = system.world.ledger.kinetic;
        if (first == 0.)
          first = kinetic;
        largest = kinetic > largest || std::isnan(kinetic) ? kinetic : largest;
      });
      if (!(largest < 1e3 * (first + at_rest)))
        return share;
    }
  return 2.;
}
} // namespace test
