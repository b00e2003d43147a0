// SPDX-License-Identifier: LGPL-2.1-or-later
// The block of friction_slide.cc with penalties that are as large as the step allows: its stopping
// distance tends to Coulomb's v^2/(2 mu g) as the step becomes smaller. Friction needs half a step
// to begin, hence the order 1.
#include "../support/scenes.h"

using namespace test;

int main()
{
  const double mu = 0.1, g = 9.81, m = 1., r = 0.01, v = 0.2;
  double       coarser = 0.;
  for (const double dt : {8e-5, 4e-5, 2e-5, 1e-5})
    {
      const double k = m * 0.04 / (dt * dt), sunk = m * g / k;
      scene::Scene scene  = empty_scene();
      scene.loads.gravity = g;
      scene.prestress     = 2. * m * g; // the block starts in equilibrium on its spring
      scene.bodies        = {lump(m, vector(0., r - sunk), vector(v, 0.)), ground()};
      scene.surfaces.push_back(on_surface(plane(1, vector(0., 1.)),
                                          {k, 0.2 * std::sqrt(k * m), mu, 0.8 * k, 0.},
                                          {{0, dealii::Point<3>(), r, 0}}));
      dynamics::System system(scene, false);
      double           furthest = 0.;
      advance(system, static_cast<unsigned long>(0.25 / dt), dt, [&]() {
        furthest = std::max(furthest, system.world.displacement.local_element(0));
      });
      const double error = std::abs(furthest / (v * v / (2. * mu * g)) - 1.);
      std::cout << "step " << std::fixed << std::setprecision(0) << 1e6 * dt
                << " us: error of the stopping distance " << std::setprecision(1) << 1e6 * error
                << " per million";
      if (coarser > 0.)
        std::cout << ", order " << std::setprecision(2) << std::log2(coarser / error);
      std::cout << '\n';
      coarser = error;
    }
}
