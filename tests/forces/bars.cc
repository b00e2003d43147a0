// SPDX-License-Identifier: LGPL-2.1-or-later
// Two lumps on a bar with a dashpot: frequency sqrt(2 k / m (1 - xi^2)), decay by the logarithmic
// decrement, tension k times the stretch; and the ledger's line for each kind of energy.
#include "../support/scenes.h"

using namespace test;

int main()
{
  const double m = 0.0107, k = 3e8, xi = 0.02, stretch = 1e-6, length = 15.875e-3;
  scene::Scene scene = empty_scene();
  scene.bodies       = {lump(m, Vector3()), lump(m, vector(length + stretch, 0.))};
  scene.bars         = {{0, 1, length, k, 2. * xi * std::sqrt(k * 0.5 * m)}};
  dynamics::System system(scene, false);
  const double     energy = 0.5 * k * stretch * stretch;
  ratio("tension at the start", system.bars.tension()[0], k * stretch);
  ratio("strain energy at the start", system.world.ledger.bar, energy);

  const double w = std::sqrt(2. * k / m) * std::sqrt(1. - xi * xi), dt = 0.005 / w;
  double       before = stretch, first = 0., last = 0., peak = 0.;
  unsigned int crossings = 0;
  advance(system, 12600, dt, [&]() {
    const double now =
        system.world.frames[1].position[0] - system.world.frames[0].position[0] - length;
    if (before < 0. && now >= 0.)
      {
        last = system.world.time - dt * now / (now - before);
        if (crossings++ == 0)
          first = last;
      }
    if (crossings == 10)
      peak = std::max(peak, now);
    before = now;
  });
  ratio("frequency", (crossings - 1) / (last - first), w / (2. * dealii::numbers::PI));
  ratio("tenth maximum",
        peak,
        stretch * std::exp(-10. * 2. * dealii::numbers::PI * xi / std::sqrt(1. - xi * xi)),
        3);
  const Ledger &ledger = system.world.ledger;
  ratio("loss in the dashpot and what is left", ledger.chain_damping + ledger.stored(), energy);
  verdict("balance closes to 1e-4", std::abs(ledger.imbalance()) < 1e-4 * energy);
  verdict("momentum zero to 1e-15 N s",
          std::abs(m * (system.world.frames[0].velocity[0] + system.world.frames[1].velocity[0])) <
              1e-15);
}
