// SPDX-License-Identifier: LGPL-2.1-or-later
// A fine chain over half a turn of a guide that moves slowly below it: the tensions of its two ends
// are in the ratio exp(mu theta) (Euler, Eytelwein), for an arc, for a spline, and with forces at
// the centres of lumps, which then do not turn. A chain on the other side of the guide is not
// touched. A lump that slides down a straight guide has the acceleration g (sin a - mu cos a).
#include "../support/capstan.h"

#include <chaindrive/path/curve.h>

using namespace test;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
constexpr double radius = capstan_radius, mu = capstan_friction;

Point<2> on_circle(const double angle)
{
  return Point<2>(radius * std::cos(angle), radius * std::sin(angle));
}

/// Three quarters of a turn, clockwise: material is inside.
path::Curve line(const bool spline)
{
  std::vector<Point<2>> points;
  const unsigned int    n = spline ? 40 : 3;
  for (unsigned int i = 0; i < n; ++i)
    points.push_back(on_circle(1.25 * PI - 1.5 * PI * i / (n - 1.)));
  return spline ? path::Curve::spline(points) : path::Curve::arc(points);
}

void pull(const std::string &name, const bool spline, const bool at_centres)
{
  scene::Scene scene = capstan(1e-9);
  if (at_centres)
    for (unsigned int i = 0; i < n_on_capstan; ++i)
      scene.bodies[i].inertia[2] = 1e-13;
  scene.guides.push_back({"guide",
                          n_on_capstan,
                          std::make_shared<const path::Curve>(line(spline)),
                          capstan_law(),
                          capstan_slaves(),
                          at_centres});
  for (const int sense : {1, -1})
    compare_tensions(name + (sense > 0 ? ", towards the loaded end" : ", towards the held end"),
                     scene,
                     sense,
                     [at_centres](const dynamics::System &system) {
                       if (at_centres)
                         verdict("  lumps have not turned",
                                 system.world.spins[n_on_capstan / 2].speed == 0.);
                     });
}
/// A lump without friction meets a straight guide: from the front, from behind, at its end along
/// the line and past it. It comes back as fast as it has come, without having been deeper in than
/// its speed carries it.
void throw_back()
{
  const double radius = 5e-3, mass = 0.1, stiffness = 1e6, speed = 2.;
  const struct
  {
    const char *name;
    Vector3     from, towards;
  } throws[] = {{"from the front", vector(0.05, 0.02, 0.), vector(0., -1., 0.)},
                {"from behind", vector(0.05, -0.02, 0.), vector(0., 1., 0.)},
                {"at the end", vector(0.12, 0., 0.), vector(-1., 0., 0.)},
                {"from behind, past the end", vector(0.102, -0.02, 0.), vector(0., 1., 0.)}};
  for (const auto &thrown : throws)
    {
      scene::Scene scene = empty_scene();
      scene.bodies       = {
                lump(mass, thrown.from, speed * thrown.towards),
                body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3())};
      scene.guides.push_back({"guide",
                              1,
                              std::make_shared<const path::Curve>(
                                  path::Curve::spline({Point<2>(), Point<2>(0.1, 0.)})),
                              {stiffness, 0., 0., stiffness, 0.},
                              {{0, Point<3>(), radius, 0}},
                              true});
      dynamics::System system(scene, false);
      const Frame     &frame   = system.world.frames[0];
      double           nearest = 1.;
      advance(system, 15000, 1e-6, [&]() {
        Vector3 arm = frame.position;
        arm[0] -= std::clamp(arm[0], 0., 0.1);
        nearest = std::min(nearest, arm.norm());
      });
      const double depth = speed * std::sqrt(mass / stiffness);
      std::cout << thrown.name << std::endl;
      ratio("  speed afterwards", frame.velocity.norm(), speed, 4);
      verdict("  it has touched, and not deeper than by its speed",
              nearest < radius && nearest > radius - 1.001 * depth);
    }
}
} // namespace

int main()
{
  pull("arc", false, false);
  pull("spline", true, false);
  pull("arc, at the centres", false, true);

  const double slope = 0.5, g = 9.81;
  for (const bool planar : {false, true})
    {
      scene::Scene scene  = empty_scene();
      scene.loads.gravity = g;
      scene.planar        = planar;
      const Vector3 down  = vector(std::cos(slope), -std::sin(slope), 0.),
                    up    = vector(std::sin(slope), std::cos(slope), 0.);
      scene.bodies        = {
                 lump(0.1, 0.1 * down + (5e-3 + 1e-12) * up),
                 lump(0.1, 0.15 * down - 8e-3 * up), // behind the guide
                 body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3())};
      path::Curve curve =
          path::Curve::spline({Point<2>(), Point<2>(2. * std::cos(slope), -2. * std::sin(slope))});
      scene.guides.push_back({"guide",
                              2,
                              std::make_shared<const path::Curve>(curve),
                              {1e6, 300., mu, 1e6, 300.},
                              {{0, Point<3>(), 5e-3, 0}, {1, Point<3>(), 5e-3, 1}},
                              true});
      dynamics::System system(scene, false);
      advance(system, 100000, 2e-6, []() {});
      ratio(planar ? "sliding down in the plane, speed" : "sliding down, speed",
            system.world.frames[0].velocity * down,
            g * (std::sin(slope) - mu * std::cos(slope)) * 0.2,
            4);
      ratio("  behind the guide nothing holds it", system.world.frames[1].velocity[1], -g * 0.2, 6);
    }
  throw_back();
}
