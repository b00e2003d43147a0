// SPDX-License-Identifier: LGPL-2.1-or-later
// A moving elastic bar hits an equal one at rest: they exchange their velocities, the stress behind
// the waves is rho c v0 / 2, the contact lasts 2 L / c. One of twice its length takes half of the
// velocity, and half of the energy as vibration. Nodes of elastic bodies have flat faces
// only as rigid ones; here a free rigid plate of a thousandth of a bar's mass stands between the
// bars, and the nodes of either end are slaves on its side of the plate. Without Poisson's ratio
// the theory of bars is exact.
#include "../support/scenes.h"

#include <deal.II/grid/grid_generator.h>

using namespace test;

int main()
{
  const double length = 0.1, width = 4e-3, v0 = 1.;
  for (const auto &bars :
       {std::pair{50u, 1u}, std::pair{100u, 1u}, std::pair{200u, 1u}, std::pair{100u, 2u}})
    {
      const unsigned int n = bars.first, ratio_of_lengths = bars.second;
      scene::Scene       scene      = empty_scene();
      scene.material.poissons_ratio = 0.;
      const double E                = scene.material.youngs_modulus;
      const double rho              = scene.material.density;
      const double c                = std::sqrt(E / rho);
      const double area = width * width, mass = rho * area * length;

      const auto add = [&](const scene::Kind kind, const unsigned int times, const double v) {
        mesh::Part   bar;
        const double half = 0.5 * times * length;
        bar.name          = "bar";
        bar.density       = rho;
        bar.mesh          = std::make_unique<dealii::Triangulation<3>>();
        dealii::GridGenerator::subdivided_hyper_rectangle(
            *bar.mesh,
            {times * n, 1, 1},
            dealii::Point<3>(-half, -0.5 * width, -0.5 * width),
            dealii::Point<3>(half, 0.5 * width, 0.5 * width),
            true);
        for (const auto &cell : bar.mesh->active_cell_iterators())
          cell->set_material_id(mesh::roller); // colouring the sides has coloured the cells as well
        scene.parts[kind] = std::make_shared<const mesh::Part>(std::move(bar));
        scene.bodies.push_back(body(scene::Motion::elastic,
                                    scene::Mount::free(),
                                    times * mass,
                                    vector(1., 1., 1.),
                                    vector(v > 0. ? -half : half, 0.),
                                    vector(v, 0.)));
        scene.bodies.back().kind = kind;
      };
      add(scene::Kind::roller, 1, v0);
      add(scene::Kind::inner_link, ratio_of_lengths, 0.);
      const double inertia = 1e-3 * mass * area;
      scene.bodies.push_back(body(scene::Motion::rigid,
                                  scene::Mount::free(),
                                  1e-3 * mass,
                                  vector(inertia, inertia, inertia),
                                  vector(0., 0.)));

      scene::ContactLaw law;
      law.stiffness = E / (length / n); // per area: one element's own
      for (const unsigned int i : {0, 1})
        {
          // the first bar's end looks along x and meets the side of the plate that looks back
          scene.surfaces.push_back(on_surface(
              plane(2, vector(i == 0 ? -1. : 1., 0.)), law, {{i, dealii::Point<3>(), width, 0}}));
          scene.surfaces.back().name          = i == 0 ? "first" : "second";
          scene.surfaces.back().elastic       = true;
          scene.surfaces.back().slave_surface = i == 0 ? 1 : 0; // colours of the ends
        }

      dynamics::System system(scene, false);
      const double     dt      = 0.3 * system.critical_time_step(); // it takes masters to be heavy
      double           plateau = 0., worst = 0., last = 0., momentum = 0.;
      unsigned int     samples = 0;
      advance(system, static_cast<unsigned long>(3. * length / c / dt), dt, [&]() {
        const double t     = system.world.time;
        const double force = system.contacts.families()[1]->records()[0].force[0];
        if (force > 0.)
          last = t;
        if (t > 0.3 * length / c && t < 1.7 * length / c)
          {
            plateau += force / area;
            ++samples;
          }
        worst    = std::max(worst, std::abs(system.world.ledger.imbalance()));
        double p = 1e-3 * mass * system.world.frames[2].velocity[0];
        p += mass * system.world.frames[0].velocity[0];
        p += ratio_of_lengths * mass * system.world.frames[1].velocity[0];
        momentum = std::max(momentum, std::abs(p / (mass * v0) - 1.));
      });
      const double struck = system.world.frames[1].velocity[0];
      std::cout << n << " elements along "
                << (ratio_of_lengths == 1 ? "each bar\n" : "one, twice as many along the other\n");
      ratio("  mean stress", plateau / samples, 0.5 * rho * c * v0, 3);
      if (ratio_of_lengths == 1) // the striker left at rest touches on without a force
        ratio("  duration", last, 2. * length / c, 2);
      ratio("  velocity of the struck bar", struck, v0 / ratio_of_lengths, 3);
      std::cout << "  velocity left to the striker: " << std::fixed << std::setprecision(3)
                << system.world.frames[0].velocity[0] / v0 << std::defaultfloat << " of v0\n";
      if (ratio_of_lengths == 1)
        verdict("  kinetic energy exchanged to 98 %", struck * struck > 0.98 * v0 * v0);
      verdict("  momentum kept to 1e-10", momentum < 1e-10);
      verdict("  imbalance below 0.5 % of the energy", worst < 5e-3 * 0.5 * mass * v0 * v0);
    }
}
