// SPDX-License-Identifier: LGPL-2.1-or-later
// A cylinder on an incline of 30 degrees rolls without slip when mu >= tan / (1 + R^2/k^2), with
// the acceleration g sin / (1 + k^2/R^2); below that it slides with g (sin - mu cos). A lumped
// roller does the same, most of whose mass does not turn.
#include "../support/scenes.h"

using namespace test;

int main()
{
  const double  g = 9.81, angle = dealii::numbers::PI / 6., radius = 5.08e-3;
  const Vector3 down_hill = vector(std::cos(angle), -std::sin(angle));
  const Vector3 normal    = vector(std::sin(angle), std::cos(angle));
  struct Case
  {
    const char *name;
    double      gyration, mu; // k^2/R^2
    bool        lumped = false;
  };
  for (const Case &c : {Case{"solid", 0.5, 0.3},
                        Case{"roller annulus", 0.7739, 0.5},
                        Case{"solid, slippery", 0.5, 0.1},
                        Case{"lumped roller", 0.15, 0.1, true},
                        Case{"lumped roller, slippery", 0.15, 0.05, true}})
    {
      const double m = 0.01, k = 1e5, inertia = c.gyration * m * radius * radius;
      scene::Scene scene  = empty_scene();
      scene.loads.gravity = g;
      scene.bodies        = {body(c.lumped ? scene::Motion::lumped : scene::Motion::rigid,
                                  scene::Mount::free(),
                                  m,
                                  vector(inertia, inertia, inertia),
                                  (radius - 0.5e-9) * normal),
                             ground()};
      scene.surfaces.push_back(on_surface(plane(1, normal),
                                          {k / 2, 15., c.mu, 0.8 * k / 2, 15.},
                                          {{0, dealii::Point<3>(0., 0., 2e-3), radius, 0},
                                           {0, dealii::Point<3>(0., 0., -2e-3), radius, 0}}));
      dynamics::System system(scene, false);
      const double     dt = 5e-6, settle = 0.02, end = 0.1;
      advance(system, static_cast<unsigned long>(settle / dt), dt, []() {});
      const double v0 = system.world.frames[0].velocity * down_hill;
      const double w0 = system.world.frames[0].angular_velocity[2];
      advance(system, static_cast<unsigned long>((end - settle) / dt), dt, []() {});
      const double v1 = system.world.frames[0].velocity * down_hill;
      const double w1 = system.world.frames[0].angular_velocity[2];

      const double least    = std::tan(angle) / (1. + 1. / c.gyration);
      const bool   rolls    = c.mu >= least;
      const double expected = rolls ? g * std::sin(angle) / (1. + c.gyration) :
                                      g * (std::sin(angle) - c.mu * std::cos(angle));
      std::cout << c.name << ": " << (rolls ? "rolls" : "slides") << '\n';
      ratio("  acceleration", (v1 - v0) / (end - settle), expected, 4);
      if (rolls)
        ratio("  rolling speed w R / v", -(w1 - w0) * radius, v1 - v0, 4);
      else
        ratio("  spin-up mu m g cos R / I",
              -(w1 - w0) / (end - settle),
              c.mu * m * g * std::cos(angle) * radius / inertia,
              4);
      verdict("  axis stays level to 1e-12 rad",
              std::abs(system.world.frames[0].rotation[0][2]) < 1e-12);
    }
}
