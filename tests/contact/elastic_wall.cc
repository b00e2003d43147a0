// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic bar hits a rigid wall at v0: the stress behind the wave is rho c v0, the contact lasts
// 2 L / c, and the bar flies off at -v0. The nodes of its end are slaves. Without Poisson's ratio
// the theory of bars is exact.
#include "../support/scenes.h"

#include <deal.II/grid/grid_generator.h>

using namespace test;

int main()
{
  const double length = 0.1, width = 4e-3, v0 = 1.;
  for (const unsigned int n : {50, 100, 200})
    {
      scene::Scene scene            = empty_scene();
      scene.material.poissons_ratio = 0.;
      const double E                = scene.material.youngs_modulus;
      const double rho              = scene.material.density;
      const double c                = std::sqrt(E / rho);

      mesh::Part bar;
      bar.name    = "bar";
      bar.density = rho;
      bar.mesh    = std::make_unique<dealii::Triangulation<3>>();
      dealii::GridGenerator::subdivided_hyper_rectangle(
          *bar.mesh,
          {n, 2, 2},
          dealii::Point<3>(-0.5 * length, 0., 0.),
          dealii::Point<3>(0.5 * length, width, width),
          true);
      for (const auto &cell : bar.mesh->active_cell_iterators())
        cell->set_material_id(mesh::roller); // colouring the sides has coloured the cells as well
      constexpr unsigned int end_face  = 1;  // x = length / 2
      scene.parts[scene::Kind::roller] = std::make_shared<const mesh::Part>(std::move(bar));
      scene.bodies                     = {body(scene::Motion::elastic,
                           scene::Mount::free(),
                           rho * length * width * width,
                           vector(1., 1., 1.),
                           vector(-0.5 * length, -0.5 * width, -0.5 * width),
                           vector(v0, 0.)),
                                          ground()};
      scene::ContactLaw law;
      law.stiffness  = E / (length / n); // per area: one element's own
      scene.surfaces = {
          on_surface(plane(1, vector(-1., 0.)), law, {{0, dealii::Point<3>(), 1., 0}})};
      scene.surfaces[0].elastic       = true;
      scene.surfaces[0].slave_surface = end_face;

      dynamics::System system(scene, false);
      const double     limit = system.critical_time_step(), dt = 0.5 * limit;
      const double     mass = system.world.copies[0].mass, area = width * width;
      double           impulse = 0., plateau = 0., worst = 0., last = 0.;
      unsigned int     samples = 0;
      advance(system, static_cast<unsigned long>(3. * length / c / dt), dt, [&]() {
        const double t     = system.world.time;
        const double force = -system.contacts.families()[0]->records()[0].force[0];
        impulse += force * dt;
        if (force > 0.)
          last = t;
        if (t > 0.3 * length / c && t < 1.7 * length / c)
          {
            plateau += force / area;
            ++samples;
          }
        worst = std::max(worst, std::abs(system.world.ledger.imbalance()));
      });
      std::cout << n << " elements along the bar\n";
      ratio("  mean stress", plateau / samples, rho * c * v0, 3);
      ratio("  duration", last, 2. * length / c, 4);
      ratio("  impulse", impulse, 2. * mass * v0, 5);
      ratio("  rebound of the centre of mass", -system.world.frames[0].velocity[0], v0, 5);
      verdict("  impulse is the change of momentum to 1e-3",
              std::abs(mass * (v0 - system.world.frames[0].velocity[0]) / impulse - 1.) < 1e-3);
      verdict("  imbalance below 0.5 % of the energy", worst < 5e-3 * 0.5 * mass * v0 * v0);
    }
}
