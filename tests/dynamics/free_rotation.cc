// SPDX-License-Identifier: LGPL-2.1-or-later
// Free rotation of an asymmetric body about its middle axis (it flips over: Dzhanibekov): angular
// and linear momentum are constant, the energy nearly so, and its error falls with the step
// squared.
#include "../support/scenes.h"

using namespace test;

int main()
{
  double before = 0.;
  for (const double dt : {4e-5, 2e-5, 1e-5})
    {
      scene::Scene scene                       = empty_scene();
      scene.bodies                             = {body(scene::Motion::rigid,
                           scene::Mount::free(),
                           2e-3,
                           vector(4e-8, 7e-8, 9e-8),
                           vector(0.1, 0.2, 0.3),
                           vector(3., -4., 5.))};
      scene.bodies[0].initial.angular_velocity = vector(0.1, 120., 0.1);
      scene.bodies[0].initial.rotation         = to_matrix(rotation_by(vector(0.3, -0.8, 0.5)));
      scene.bodies[0].initial.angular_velocity =
          scene.bodies[0].initial.rotation * scene.bodies[0].initial.angular_velocity;
      dynamics::System    system(scene, false);
      World              &world        = system.world;
      const Vector3       momentum     = world.rotations[0].momentum;
      const double        energy       = world.kinetic_energy();
      const Vector3       v            = world.frames[0].velocity;
      double              worst_energy = 0.;
      bool                flipped      = false;
      const Vector3       axis         = vector(world.frames[0].rotation[0][1],
                                  world.frames[0].rotation[1][1],
                                  world.frames[0].rotation[2][1]);
      const unsigned long n            = dt < 1.5e-5 ? 100000 : static_cast<unsigned long>(1. / dt);
      advance(system, n, dt, [&]() {
        worst_energy   = std::max(worst_energy, std::abs(world.kinetic_energy() / energy - 1.));
        const Frame &f = world.frames[0];
        flipped =
            flipped || vector(f.rotation[0][1], f.rotation[1][1], f.rotation[2][1]) * axis < -0.9;
      });
      std::cout << n << " steps of " << dt * 1e6 << " us\n";
      verdict("  angular momentum kept to 1e-12",
              (world.rotations[0].momentum - momentum).norm() < 1e-12 * momentum.norm());
      verdict("  velocity kept exactly", (world.frames[0].velocity - v).norm() == 0.);
      // w = R I^-1 R^T L must still belong to that momentum
      Vector3 in_body =
          dealii::transpose(world.frames[0].rotation) * world.frames[0].angular_velocity;
      in_body[0] *= 4e-8;
      in_body[1] *= 7e-8;
      in_body[2] *= 9e-8;
      verdict("  R I R^T w equals it to 1e-6",
              (world.frames[0].rotation * in_body - momentum).norm() < 1e-6 * momentum.norm());
      verdict("  the body flips over", flipped);
      std::cout << "  largest error of the energy " << std::setprecision(2) << worst_energy * 1e6
                << " per million";
      if (before > 0.)
        std::cout << ", order " << std::setprecision(2) << std::log2(before / worst_energy);
      std::cout << '\n';
      before = worst_energy;
    }
}
