// SPDX-License-Identifier: LGPL-2.1-or-later
// Whatever the state, an interface puts equal and opposite forces on its two bodies at one point:
// their sum and the sum of their moments about any point are zero to round-off.
#include "../support/scenes.h"

#include <chaindrive/bodies/make_world.h>

#include <random>

using namespace test;

int main()
{
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> any(-1., 1.);
  const auto                             random = [&](const double s) {
    Vector3 numbers; // one after the other: compilers evaluate arguments in orders of their own
    for (unsigned int d = 0; d < 3; ++d)
      numbers[d] = s * any(generator);
    return numbers;
  };

  double       worst_force = 0., worst_moment = 0.;
  unsigned int touching = 0;
  for (unsigned int trial = 0; trial < 500; ++trial)
    {
      scene::Scene scene = empty_scene();
      for (unsigned int b = 0; b < 2; ++b)
        {
          const Vector3 position = random(1e-4), velocity = random(1.);
          scene.bodies.push_back(body(scene::Motion::rigid,
                                      scene::Mount::free(),
                                      1.,
                                      vector(1., 1., 1.),
                                      position,
                                      velocity));
          scene.bodies[b].initial.rotation         = to_matrix(rotation_by(random(0.05)));
          scene.bodies[b].initial.angular_velocity = random(100.);
        }
      scene.bores             = {{"bore",
                                  scene::Interface::other,
                                  {1e8, 10., 0.3, 0.8e8, 10.},
                                  {{0,
                                    dealii::Point<3>(0.01, 0., 0.),
                                    5.05e-3,
                                    {1, dealii::Point<3>(0.01, 0., 2e-3), 5e-3, 0}}}}};
      World             world = make_world(scene);
      contact::Contacts contacts(scene, world, false);
      contacts.add_forces(world, 1e-7);
      Vector3 force, moment;
      double  size = 0.;
      for (unsigned int b = 0; b < 2; ++b)
        {
          const Vector3 f = vector(world.force.local_element(3 * b),
                                   world.force.local_element(3 * b + 1),
                                   world.force.local_element(3 * b + 2));
          const Vector3 m = vector(world.moment.local_element(3 * b),
                                   world.moment.local_element(3 * b + 1),
                                   world.moment.local_element(3 * b + 2));
          force += f;
          moment += m + dealii::cross_product_3d(world.frames[b].position, f);
          size += f.norm();
        }
      if (size == 0.)
        continue;
      ++touching;
      worst_force  = std::max(worst_force, force.norm() / size);
      worst_moment = std::max(worst_moment, moment.norm() / (size * 0.01));
    }
  std::cout << "touching in " << touching << " of 500 states\n";
  verdict("sum of forces below 1e-15 of their size", worst_force < 1e-15);
  verdict("sum of moments below 1e-14 of force times 1 cm", worst_moment < 1e-14);
}
