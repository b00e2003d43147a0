// SPDX-License-Identifier: LGPL-2.1-or-later
// The printed critical time step against exact limits: a spring pair, a chain of bars, a bar with a
// dashpot, with drag, a stiff bar beside a damped soft one, a rigid roller on a frictional surface;
// and runs just below and just above it. With an argument: for so many steps.
#include "../support/scenes.h"

using namespace test;

namespace
{
unsigned long steps = 20000;

/// Largest amplitude after many steps of @p share of the limit, over the initial one.
double growth(const scene::Scene &scene, const double share, const double kick)
{
  dynamics::System system(scene, false);
  const double     dt = share * system.critical_time_step();
  system.world.velocity.local_element(0) += kick;
  double largest = 0.;
  advance(system, steps, dt, [&]() {
    largest =
        std::max(largest, std::min(1e300, std::abs(system.world.velocity.local_element(0)) / kick));
  });
  return largest;
}
} // namespace

int main(int argc, char **argv)
{
  if (argc > 1)
    steps = std::stoul(argv[1]);
  {
    const double m = 0.0107, k = 3e8;
    scene::Scene scene = empty_scene();
    scene.bodies       = {lump(m, Vector3()), lump(m, vector(0.01, 0.))};
    scene.bars         = {{0, 1, 0.01, k, 0.}};
    ratio("two lumps and a bar",
          dynamics::System(scene, false).critical_time_step(),
          2. / std::sqrt(2. * k / m));
    verdict("  bounded at 0.98", growth(scene, 0.98, 1e-6) < 20.);
    verdict("  blows up at 1.02", growth(scene, 1.02, 1e-6) > 1e6);

    const double xi = 0.1, w = std::sqrt(2. * k / m);
    scene.bars[0].damping = 2. * xi * std::sqrt(k * 0.5 * m);
    ratio("with a dashpot",
          dynamics::System(scene, false).critical_time_step(),
          2. / w * (std::sqrt(1. + xi * xi) - xi));
    verdict("  bounded at 0.98", growth(scene, 0.98, 1e-6) < 20.);
    verdict("  blows up at 1.02", growth(scene, 1.02, 1e-6) > 1e6);

    // without dashpot dt^2 w^2 + 2 drag dt = 4 is exact, and r times 2/w with this drag
    const double r        = 0.9;
    scene.bars[0].damping = 0.;
    scene.loads.drag      = w * (1. - r * r) / r;
    const double found    = dynamics::System(scene, false).critical_time_step() * w / 2.;
    ratio("with drag, a bound", found, 1. / (1. + scene.loads.drag / w));
    verdict("  bounded at 0.98 of the exact limit", growth(scene, 0.98 * r / found, 1e-6) < 20.);
    verdict("  blows up at 1.02 of it", growth(scene, 1.02 * r / found, 1e-6) > 1e6);
    verdict("  which is above the bound", found < r);
  }
  {
    const double       m = 0.0107, k = 3e8;
    const unsigned int n     = 60;
    scene::Scene       scene = empty_scene();
    for (unsigned int i = 0; i < n; ++i)
      scene.bodies.push_back(lump(m, vector(0.01 * i, 0.)));
    for (unsigned int i = 0; i + 1 < n; ++i)
      scene.bars.push_back({i, i + 1, 0.01, k, 0.});
    const double w = 2. * std::sqrt(k / m) * std::sin(0.5 * dealii::numbers::PI * (n - 1) / n);
    ratio("chain of 60 lumps", dynamics::System(scene, false).critical_time_step(), 2. / w, 4);
    verdict("  bounded at 0.98", growth(scene, 0.98, 1e-6) < 20.);
    verdict("  blows up at 1.02", growth(scene, 1.02, 1e-6) > 1e6);
  }
  for (const auto &[name, first, second] :
       {std::make_tuple("a stiff bar and a damped one", 3e12, std::make_pair(3e8, 300.)),
        std::make_tuple("a bar and a dashpot", 3e8, std::make_pair(1., 3e4))})
    {
      // between three lumps; 4 M - 2 dt C - dt^2 K is singular at the limit
      const double m     = 0.0107;
      scene::Scene scene = empty_scene();
      scene.bodies = {lump(m, Vector3()), lump(m, vector(0.01, 0.)), lump(m, vector(0.02, 0.))};
      scene.bars   = {{0, 1, 0.01, first, 0.}, {1, 2, 0.01, second.first, second.second}};
      double dt    = 1e-9;
      for (unsigned int i = 0; i < 100; ++i)
        {
          const double a = first, b = second.first + 2. * second.second / dt;
          dt = 2. / std::sqrt((a + b + std::sqrt(a * a - a * b + b * b)) / m);
        }
      ratio(name, dynamics::System(scene, false).critical_time_step(), dt);
      verdict("  bounded at 0.98", growth(scene, 0.98, 1e-6) < 20.);
      verdict("  blows up at 1.02", growth(scene, 1.02, 1e-6) > 1e6);
    }
  {
    // slip of the surface u - R phi: 1/m + R^2/I, and the normal spring at 1/m
    const double m = 1.95e-3, inertia = 3.895e-8, r = 5.08e-3, k = 2e8;
    scene::Scene scene  = empty_scene();
    scene.loads.gravity = 1e5; // keeps the contact closed
    scene.bodies        = {body(scene::Motion::rigid,
                         scene::Mount::free(),
                         m,
                         vector(inertia, inertia, inertia),
                         vector(0., r - 0.9e-9)),
                           ground()};
    scene.surfaces.push_back(on_surface(
        plane(1, vector(0., 1.)), {k, 0., 100., 0.8 * k, 0.}, {{0, dealii::Point<3>(), r, 0}}));
    const double w = std::sqrt(0.8 * k * (1. / m + r * r / inertia));
    ratio("roller that sticks", dynamics::System(scene, false).critical_time_step(), 2. / w);
    verdict("  bounded at 0.98", growth(scene, 0.98, 1e-6) < 20.);
    verdict("  blows up at 1.02", growth(scene, 1.02, 1e-6) > 100.);
  }
  for (const double angle : {0., 0.6, 1.5})
    {
      // A roller without friction between a bar and a tooth, which act along one line: sharp
      // wherever on the sprocket that is.
      const double m = 0.0107, r = 5.08e-3, k_bar = 3e8, k = 1.1e9, pull = 1e5, far = 0.05;
      const auto   turned = [angle](const double x, const double y) {
        return vector(x * std::cos(angle) - y * std::sin(angle),
                      x * std::sin(angle) + y * std::cos(angle));
      };
      scene::Scene scene               = empty_scene();
      scene.prestress                  = pull;
      scene.bodies                     = {lump(m, turned(r - pull / k, far)), ground(), ground()};
      scene.bodies[2].initial.position = turned(-0.05, far);
      scene.bars                       = {{0, 2, 0.05 + r - pull / k - pull / k_bar, k_bar, 0.}};
      scene.surfaces.push_back(on_surface(
          plane(1, turned(1., 0.)), {k, 0., 0., 0., 0.}, {{0, dealii::Point<3>(), r, 0}}));
      const double w = std::sqrt((k_bar + k) / m);
      ratio("roller between bar and tooth",
            dynamics::System(scene, false).critical_time_step(),
            2. / w);
      verdict("  bounded at 0.98", growth(scene, 0.98, 1e-6) < 20.);
      verdict("  blows up at 1.02", growth(scene, 1.02, 1e-6) > 1e6);
    }
  {
    // A light loaded hub between two rollers without friction: normal forces turn it.
    const double m = 0.0107, r = 1e-3, k = 2e8, soft = 1e4, pull = 1e5, far = 0.1, inertia = 1e-6;
    scene::Scene scene = empty_scene();
    scene.prestress    = pull;
    scene.bodies       = {lump(m, vector(r - pull / k, far)),
                          lump(m, vector(-r + pull / k, far)),
                          body(scene::Motion::rigid,
                         scene::Mount::revolute(),
                         1.,
                         vector(1., 1., inertia),
                         Vector3())};
    scene.bars         = {{0, 1, 2. * (r - pull / k) - pull / soft, soft, 0.}};
    for (const unsigned int side : {0, 1})
      scene.surfaces.push_back(on_surface(plane(2, vector(side == 0 ? 1. : -1., 0.)),
                                          {k, 0., 0., 0., 0.},
                                          {{side, dealii::Point<3>(), r, 0}}));
    ratio("two rollers on a light hub",
          dynamics::System(scene, false).critical_time_step(),
          2. / std::sqrt(k * (1. / m + 2. * far * far / inertia)));
    verdict("  bounded at 0.98", growth(scene, 0.98, 1e-6) < 20.);
    verdict("  blows up at 1.02", growth(scene, 1.02, 1e-6) > 1e6);
  }
  {
    // A pin in a bore that begins concentric: closed along any direction, here that of the bar.
    const double m = 0.0107, k = 2e8, k_bar = 3e8;
    scene::Scene scene               = empty_scene();
    scene.bodies                     = {lump(m, Vector3()), ground(), ground()};
    scene.bodies[2].initial.position = vector(0., 0.05);
    scene.bars                       = {{0, 2, 0.05, k_bar, 0.}};
    scene::BoreFamily joint;
    joint.name  = "pin";
    joint.law   = {k, 0., 0., 0., 0.};
    joint.pairs = {{1, dealii::Point<3>(), 5.05e-3, {0, dealii::Point<3>(), 5e-3, 0}}};
    scene.bores.push_back(joint);
    ratio("pin in a bore, bar across",
          dynamics::System(scene, false).critical_time_step(),
          2. / std::sqrt((k + k_bar) / m));
  }
}
