// SPDX-License-Identifier: LGPL-2.1-or-later
// A fine chain over half a turn of a guide that moves slowly below it: the tensions of its two ends
// are in the ratio exp(mu theta) (Euler, Eytelwein), for an arc, for a spline, and with forces at
// the centres of lumps, which then do not turn. A chain on the other side of the guide is not
// touched. A lump that slides down a straight guide has the acceleration g (sin a - mu cos a).
#include "../support/scenes.h"

#include <chaindrive/path/curve.h>

using namespace test;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
constexpr double radius = 0.05, mu = 0.1, r = 1e-4;

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
  const double       force = 10.;
  const unsigned int n     = 31; // on the guide, 6 degrees apart
  const double       step = PI / (n - 1), m = 1e-4, k_contact = 1e5, k_bar = 1e6;

  scene::Scene scene = empty_scene();
  scene.loads.drag   = 200.;
  std::vector<scene::SlavePoint> slaves;
  const double                   seat = radius + r + 1e-9;
  for (unsigned int i = 0; i < n; ++i)
    {
      scene.bodies.push_back(lump(m, vector(seat * std::cos(i * step), seat * std::sin(i * step))));
      if (at_centres)
        scene.bodies.back().inertia[2] = 1e-13;
      slaves.push_back({i, Point<3>(), r, 0});
      if (i > 0)
        scene.bars.push_back({i - 1, i, 2. * seat * std::sin(0.5 * step), k_bar, 2.});
    }
  const unsigned int guide = n, anchor = n + 1, far = n + 2;
  for (unsigned int i = 0; i < 3; ++i)
    scene.bodies.push_back(ground());
  scene.bodies[anchor].initial.position = vector(seat, -0.1);  // holds the end at angle 0
  scene.bodies[far].initial.position    = vector(-seat, -1e3); // soft and long: a constant force
  turn(scene, guide, std::make_shared<functions::Ramp>(0.5, 0., 0.01));
  scene.bars.push_back({anchor, 0, 0.1, k_bar, 2.});
  scene.bars.push_back({n - 1, far, 0.5e3, force / 0.5e3, 0.});
  scene.guides.push_back({"guide",
                          guide,
                          std::make_shared<const path::Curve>(line(spline)),
                          {k_contact, 1., mu, k_contact, 1.},
                          slaves,
                          at_centres});
  for (const int sense : {1, -1})
    {
      scene.shafts[0].sense = sense;
      dynamics::System system(scene, false);
      const double     dt  = 0.5 * system.critical_time_step();
      double           sum = 0., samples = 0.;
      advance(system, static_cast<unsigned long>(0.08 / dt), dt, [&]() {
        if (system.world.time > 0.05)
          {
            sum += system.bars.tension()[n - 1] / system.bars.tension()[n];
            samples += 1.;
          }
      });
      ratio(name + (sense > 0 ? ", towards the loaded end" : ", towards the held end"),
            sense > 0 ? sum / samples : samples / sum,
            std::exp(mu * PI),
            3);
      if (at_centres)
        verdict("  lumps have not turned", system.world.spins[n / 2].speed == 0.);
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
}
