// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic rollers in free flight among rigid ones, more of them than one batch holds: each centre
// of mass falls as a rigid body's, spin keeps its angular momentum, energy is kept to second order
// in the step, and drag takes what the ledger says.
#include "../support/scenes.h"

#include <chaindrive/mesh/generate/links.h>

using namespace test;

namespace
{
constexpr unsigned int n_elastic = 11;

scene::Scene make_scene(const double drag)
{
  scene::Scene scene  = empty_scene();
  scene.loads.gravity = 9.81;
  scene.loads.drag    = drag;
  const auto chain    = drive::make_chain(parameters::Chain());
  const auto part     = std::make_shared<const mesh::Part>(
      mesh::make_roller(chain, scene.material.density, mesh::RollerGrid(1, 24, 4)));
  scene.parts[scene::Kind::roller] = part;
  for (unsigned int k = 0; k <= n_elastic; ++k)
    {
      scene::Body roller = body(k == 4 ? scene::Motion::rigid : scene::Motion::elastic,
                                scene::Mount::free(),
                                part->meshed.mass,
                                vector(part->meshed.inertia[0][0],
                                       part->meshed.inertia[1][1],
                                       part->meshed.inertia[2][2]),
                                vector(0.1 + 0.02 * k, 0.3, -0.1 * k),
                                vector(4. - k, 2. + 0.5 * k, 1.));
      roller.initial.rotation         = to_matrix(rotation_by(vector(0.1 * k, 0.2, 0.7 * k)));
      roller.initial.angular_velocity = roller.initial.rotation * vector(0., 0., 40. + 60. * k);
      scene.bodies.push_back(roller);
    }
  return scene;
}

/// Angular momentum of copy @p copy about its centre of mass, from nodes at the same instant.
Vector3 angular_momentum(const dynamics::System &system, const unsigned int copy, const double dt)
{
  const BodyBatches &copies = system.world.copies[0];
  const Frame       &frame  = system.world.frames[copies.bodies[copy]];
  Vector3            sum;
  for (unsigned int node = 0; node < copies.n_nodes(); ++node)
    {
      // x_n+1/2 and v_n+1/2: with forces between nodes only, their angular momentum is constant
      Vector3 v, x = copies.position_now(copy, node);
      for (unsigned int d = 0; d < 3; ++d)
        v[d] = NodeView(copies.velocity).component(copies.index(copy, node), d);
      x += 0.5 * dt * v;
      sum += copies.nodes.mass[node] *
             dealii::cross_product_3d(x - frame.position - 0.5 * dt * frame.velocity,
                                      v - frame.velocity);
    }
  return sum;
}
} // namespace

int main()
{
  const double end    = 2e-4;
  double       before = 0.;
  for (const double drag : {0., 200.})
    for (const double dt : {1.2e-7, 0.6e-7})
      {
        const scene::Scene scene = make_scene(drag);
        dynamics::System   system(scene, false);
        const World       &world = system.world;
        const unsigned int n     = static_cast<unsigned int>(std::lround(end / dt));
        advance(system, 1, dt, []() {});
        std::vector<Vector3> momentum(n_elastic);
        for (unsigned int copy = 0; copy < n_elastic; ++copy)
          momentum[copy] = angular_momentum(system, copy, dt);
        double worst = 0.;
        advance(
            system, n, dt, [&]() { worst = std::max(worst, std::abs(world.ledger.imbalance())); });

        double fall = 0., spin = 0.;
        for (unsigned int k = 0; k <= n_elastic; ++k)
          {
            const double   t     = world.time;
            const Vector3 &start = scene.bodies[k].initial.position;
            const Vector3 &v     = scene.bodies[k].initial.velocity;
            if (drag == 0.)
              fall = std::max(
                  fall,
                  (world.frames[k].position - start - t * v + vector(0., 0.5 * 9.81 * t * t))
                      .norm());
            else
              fall = std::max(fall, (world.frames[k].velocity - v * std::exp(-drag * t)).norm());
          }
        for (unsigned int copy = 0; copy < n_elastic; ++copy)
          spin = std::max(spin,
                          (angular_momentum(system, copy, dt) - momentum[copy]).norm() /
                              momentum[copy].norm());
        std::cout << "drag " << drag << " /s, steps of " << dt * 1e6 << " us, "
                  << world.copies[0].n_batches() << " batches\n";
        if (drag == 0.)
          {
            verdict("  centres of mass on their parabolas to 1e-12 m", fall < 1e-12);
            verdict("  angular momentum kept to 1e-10", spin < 1e-10);
            verdict("  imbalance below 1e-9 of the energy at the start",
                    worst < 1e-9 * world.ledger.initial);
            if (before > 0.)
              std::cout << "  order of the imbalance in the step: " << std::fixed
                        << std::setprecision(1) << std::log2(before / worst) << std::defaultfloat
                        << '\n';
            before = worst;
          }
        else
          {
            verdict("  velocities fall by exp(-drag t) and gravity to 0.005 m/s", fall < 5e-3);
            verdict("  imbalance below 1e-5 of the energy at the start",
                    worst < 1e-5 * world.ledger.initial);
          }
      }

  const scene::Scene scene = make_scene(0.);
  dynamics::System   system(scene, false);
  for (const auto &vote : system.step_limits())
    std::cout << vote.source << ": critical time step " << std::setprecision(4) << vote.limit * 1e6
              << " us\n";
}
