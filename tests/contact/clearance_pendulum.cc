// SPDX-License-Identifier: LGPL-2.1-or-later
// A pendulum whose bore hangs on a fixed pin with the clearance c: the contact point rolls round
// the pin without friction. Linearised: M = [[m c^2, m c l], [m c l, I + m l^2]],
// K = diag(m g c, m g l) in the angles of the clearance and of the body.
#include "../support/scenes.h"

using namespace test;

int main()
{
  const double m = 1., l = 0.05, c = 45e-6, g = 9.81, inertia = l * l / 3., pin = 2.62e-3;
  // frequencies of the 2 x 2 problem
  const double a     = m * c * c * (inertia + m * l * l) - m * c * l * m * c * l;
  const double b     = -(m * c * c * m * g * l + (inertia + m * l * l) * m * g * c);
  const double d     = m * g * c * m * g * l;
  const double root  = std::sqrt(b * b - 4. * a * d);
  const double slow2 = (-b - root) / (2. * a);
  const double k     = 1e7;

  scene::Scene scene  = empty_scene();
  scene.loads.gravity = g;
  const double swing  = 1e-3; // rad; the slow mode moves both angles, in the ratio of its vector
  const double lean   = slow2 * m * c * l * swing / (m * g * c - slow2 * m * c * c);
  // The bore's centre hangs the clearance, and what the spring gives, below the pin's.
  const double  deep               = c + 0.9e-9;
  const Vector3 bore               = deep * vector(std::sin(lean), -std::cos(lean));
  scene.bodies                     = {body(scene::Motion::rigid,
                       scene::Mount::free(),
                       m,
                       vector(inertia, inertia, inertia),
                       bore + l * vector(std::sin(swing), -std::cos(swing))),
                                      ground()};
  scene.bodies[0].initial.rotation = to_matrix(rotation_about_z(swing));
  scene.bores                      = {
                           {"bore",
                            scene::Interface::other,
                            {k / 2, 2. * 0.2 * std::sqrt(k * m) / 2, 0., 0., 0.},
                            {{0, dealii::Point<3>(0., l, 0.), pin + c, {1, dealii::Point<3>(0., 0., 2e-3), pin, 0}},
                             {0, dealii::Point<3>(0., l, 0.), pin + c, {1, dealii::Point<3>(0., 0., -2e-3), pin, 0}}}}};
  dynamics::System system(scene, false);
  double           first = 0., last = 0., before = swing;
  unsigned int     crossings = 0;
  const double     dt        = 4e-5;
  advance(system, 70000, dt, [&]() {
    const double now =
        std::atan2(system.world.frames[0].rotation[1][0], system.world.frames[0].rotation[0][0]);
    if (before < 0. && now >= 0.)
      {
        last = system.world.time - dt * now / (now - before);
        if (crossings++ == 0)
          first = last;
      }
    before = now;
  });
  const double frequency = (crossings - 1) / (last - first);
  const double exact     = std::sqrt(slow2) / (2. * dealii::numbers::PI);
  const double rigid = std::sqrt(m * g * l / (inertia + m * l * l)) / (2. * dealii::numbers::PI);
  std::cout << std::setprecision(6) << "linear theory with clearance " << exact << " Hz, without "
            << rigid << " Hz\n";
  ratio("frequency", frequency, exact, 4);
  verdict("its shift by the clearance is seen (half to twice)",
          (rigid - frequency) > 0.5 * (rigid - exact) &&
              (rigid - frequency) < 2. * (rigid - exact));
}
