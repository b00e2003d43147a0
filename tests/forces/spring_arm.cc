// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies on mounts, and force elements: pendulums about any axis and pivot, torsion springs, a
// stop, a bushing swing as closed forms say and keep their energy; the critical time step is that
// of their springs; an arm with a shoe presses a string aside as far as both balance; a rail stands
// still.
#include "../support/scenes.h"

#include <chaindrive/contact/drum.h>
#include <chaindrive/forces/bushing.h>
#include <chaindrive/forces/torsion_spring.h>

using namespace test;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
constexpr double mass = 0.2, arm = 0.1;

/// An arm that turns about @p axis through the origin, its centre of mass at @p at.
scene::Body arm_about(const Vector3 &axis, const Vector3 &at, const Vector3 &inertia)
{
  return body(scene::Motion::rigid, scene::Mount::revolute(axis, Point<3>()), mass, inertia, at);
}

double drift_of_energy(const dynamics::System &system)
{
  const Ledger &ledger = system.world.ledger;
  return std::abs(ledger.imbalance()) / std::max(std::abs(ledger.kinetic), 1e-12);
}

/// Half a period of small swings about the state of rest: the time from one stop of the motion to
/// the next, which a start at rest aside of it begins with.
double half_period(dynamics::System &system, const double dt)
{
  double before = 0., found = 0.;
  advance(system, 4000000, dt, [&]() {
    const double speed = system.world.hubs[0].speed;
    if (found == 0. && before * speed < 0.)
      found = system.world.time - dt * speed / (speed - before);
    before = speed;
    if (found > 0.)
      throw found;
  });
  return found;
}

double half_period_of(dynamics::System &system, const double dt)
{
  try
    {
      return half_period(system, dt);
    }
  catch (const double found)
    {
      return found;
    }
}
} // namespace

int main()
{
  // about z and about x, gravity along -y: T = 2 pi sqrt(I / (m g a))
  const double g = 9.81, own = 1e-4, inertia = own + mass * arm * arm, aside = 1e-3;
  for (const bool about_x : {false, true})
    {
      scene::Scene scene  = empty_scene();
      scene.loads.gravity = g;
      const Vector3 at    = about_x ? vector(0., -arm * std::cos(aside), arm * std::sin(aside)) :
                                      vector(arm * std::sin(aside), -arm * std::cos(aside), 0.);
      scene.bodies        = {arm_about(about_x ? vector(1., 0., 0.) : vector(0., 0., 1.),
                                       at,
                                about_x ? vector(own, 2., 3.) : vector(2., 3., own))};
      dynamics::System system(scene, false);
      const double     period = 2. * PI * std::sqrt(inertia / (mass * g * arm));
      ratio(about_x ? "pendulum about x, half a period" : "pendulum about z, half a period",
            half_period_of(system, period / 4000.),
            0.5 * period,
            5);
      verdict("  energy to 1e-6",
              std::abs(system.world.ledger.imbalance()) <
                  1e-6 * 0.5 * mass * g * arm * aside * aside);
    }

  // a torsion spring with preload: about the angle M0 / k with the frequency sqrt(k / I)
  const double k = 50., preload = 5.;
  {
    scene::Scene scene = empty_scene();
    scene.bodies       = {
              arm_about(vector(0., 0., 1.), vector(arm, 0., 0.), vector(2., 3., own)),
              body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3())};
    scene.forces = {std::make_shared<const TorsionSpring>(0, 1, k, 0., preload)};
    dynamics::System system(scene, false);
    ratio("critical time step of the torsion spring",
          system.critical_time_step(),
          2. * std::sqrt(inertia / k),
          6);
    ratio("torsion spring, half a period",
          half_period_of(system, 1e-5),
          PI * std::sqrt(inertia / k),
          5);
    ratio("  furthest angle", system.world.hubs[0].angle, 2. * preload / k, 5);
    verdict("  what is fixed stands still",
            system.world.frames[1].position.norm() == 0. && system.world.hubs[1].angle == 0.);
  }

  // between two arms that turn, the second as heavy three times: what one gains the other loses
  {
    scene::Scene scene = empty_scene();
    scene.bodies       = {arm_about(vector(0., 0., 1.), Vector3(), vector(2., 3., inertia)),
                          arm_about(vector(0., 0., 1.), Vector3(), vector(2., 3., 3. * inertia))};
    scene.forces       = {std::make_shared<const TorsionSpring>(0, 1, k, 0., preload)};
    dynamics::System system(scene, false);
    ratio("between two that turn, half a period",
          half_period_of(system, 1e-5),
          PI * std::sqrt(0.75 * inertia / k),
          5);
    ratio("  angle of the second", system.world.hubs[1].angle, -system.world.hubs[0].angle / 3., 5);
    verdict("  energy to 1e-6 of what the spring gave",
            std::abs(system.world.ledger.imbalance()) < 1e-6 * preload * preload / k);
  }

  // a dashpot: amplitudes fall by exp(-pi c / (2 m w)) in half a period, and the ledger knows it
  {
    scene::Scene scene = empty_scene();
    scene.bodies       = {
              arm_about(vector(0., 0., 1.), vector(arm, 0., 0.), vector(2., 3., own)),
              body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3())};
    const double c = 2. * 0.1 * std::sqrt(k * inertia);
    scene.forces   = {std::make_shared<const TorsionSpring>(0, 1, k, c, preload)};
    dynamics::System system(scene, false);
    half_period_of(system, 1e-5);
    ratio("with a tenth of critical damping, furthest angle",
          system.world.hubs[0].angle,
          preload / k * (1. + std::exp(-PI * 0.1 / std::sqrt(1. - 0.01))),
          5);
    verdict("  energy to 1e-5 of what the spring gave",
            std::abs(system.world.ledger.imbalance()) < 1e-5 * preload * preload / k);
  }

  // a stop throws an arm back as fast as it came
  {
    scene::Scene scene = empty_scene();
    scene.bodies       = {
              arm_about(vector(0., 0., 1.), vector(arm, 0., 0.), vector(2., 3., own)),
              body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3())};
    scene.bodies[0].initial.angular_velocity = vector(0., 0., 3.);
    scene.forces                             = {std::make_shared<const Stop>(0, 1, 0.01, 1, 1e5)};
    dynamics::System system(scene, false);
    advance(system, 20000, 1e-6, []() {});
    ratio("speed after a stop", system.world.hubs[0].speed, -3., 6);
    verdict("  energy to 1e-6", drift_of_energy(system) < 1e-6);
  }

  // one with a dashpot, which does not pull: it lets go when spring and dashpot balance, at the
  // time at which x'' of x = exp(-z t) sin(w t) is zero, with the speed exp(-z t) of the first one
  // (Schwager & Poeschel 2007, Granular Matter 9, 465)
  {
    scene::Scene scene = empty_scene();
    scene.bodies       = {
              arm_about(vector(0., 0., 1.), vector(arm, 0., 0.), vector(2., 3., own)),
              body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3())};
    scene.bodies[0].initial.angular_velocity = vector(0., 0., 3.);
    const double z = 0.1, w = std::sqrt(1. - z * z), c = 2. * z * std::sqrt(1e5 * inertia);
    scene.forces = {std::make_shared<const Stop>(0, 1, 0.01, 1, 1e5, c)};
    dynamics::System system(scene, false);
    advance(system, 200000, 1e-7, []() {});
    const double time = (PI - std::atan(2. * z * w / (w * w - z * z))) / w;
    ratio("speed after a stop with a dashpot",
          system.world.hubs[0].speed,
          -3. * std::exp(-z * time),
          4);
    const Ledger &ledger = system.world.ledger;
    verdict("  the ledger has what is missing to 1e-4",
            std::abs(ledger.imbalance()) < 1e-4 * ledger.spring_damping &&
                ledger.spring_damping > 0.);
  }

  // a bushing: a mass on three springs
  {
    scene::Scene  scene     = empty_scene();
    const Vector3 stiffness = vector(1e4, 4e4, 9e4);
    scene.bodies            = {
                   lump(mass, vector(0.3, 0., 0.), vector(1., 1., 1.)),
                   body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3())};
    scene.forces = {std::make_shared<const Bushing>(0, 1, Point<3>(0.3, 0., 0.), stiffness)};
    dynamics::System system(scene, false);
    ratio("critical time step of the bushing",
          system.critical_time_step(),
          2. * std::sqrt(mass / 9e4),
          6);
    const double quarter = 0.5 * PI * std::sqrt(mass / 1e4);
    advance(system, 20000, quarter / 20000., []() {});
    const Vector3 way = system.world.frames[0].position - scene.bodies[0].initial.position;
    ratio("bushing: furthest along x", way[0], std::sqrt(mass / 1e4), 6);
    verdict("  along y, twice as stiff in the root, back in the middle to 1e-6",
            std::abs(way[1]) < 1e-6 * std::sqrt(mass / 4e4));
    verdict("  energy to 1e-7",
            std::abs(system.world.ledger.imbalance()) < 1e-7 * system.world.ledger.initial);
  }

  // a spring presses the shoe of an arm from above against a string of beads under tension: the
  // shoe's force times its lever is the spring's moment, and the string's two ends hold it
  {
    scene::Scene       scene = empty_scene();
    const unsigned int n     = 41;
    const double spacing = 0.01, pull = 200., k_bar = 1e6, radius = 0.03, bead = 1e-3, m = 1e-3;
    const double length = spacing / (1. + pull / k_bar / spacing);
    std::vector<scene::SlavePoint> slaves;
    for (unsigned int i = 0; i < n; ++i)
      {
        const Vector3 at  = vector((i - 0.5 * (n - 1)) * spacing, 0., 0.);
        const bool    end = i == 0 || i == n - 1;
        scene.bodies.push_back(
            end ? body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), at) :
                  lump(m, at));
        if (!end)
          slaves.push_back({i, Point<3>(), bead, i});
        if (i > 0)
          scene.bars.push_back({i - 1, i, length, k_bar, 5.});
      }
    const unsigned int shoe  = n;
    const Vector3      pivot = vector(-0.2, radius + bead, 0.);
    scene.bodies.push_back(body(scene::Motion::rigid,
                                scene::Mount::revolute(vector(0., 0., 1.), Point<3>(pivot)),
                                mass,
                                vector(1., 1., own),
                                vector(0., radius + bead + 1e-9, 0.)));
    scene.surfaces.push_back(on_surface(
        std::make_shared<const contact::Drum>(shoe, radius), {1e6, 20., 0., 0., 0.}, slaves));
    scene.forces     = {std::make_shared<const TorsionSpring>(shoe, 0, 20., 2., -8.)};
    scene.loads.drag = 100.;
    dynamics::System system(scene, false);
    const double     dt = 0.5 * system.critical_time_step();
    advance(system, static_cast<unsigned long>(1. / dt), dt, []() {});
    Vector3 force; // on the shoe
    for (const auto &family : system.contacts.families())
      for (const contact::Record &record : family->records())
        force -= record.force;
    const auto   &hub   = system.world.hubs.back();
    const Vector3 lever = system.world.frames[shoe].position - pivot;
    ratio("moment of the string on the arm over that of the spring",
          cross_product_3d(lever, force)[2],
          8. + 20. * hub.angle,
          4);
    double ends = 0.;
    for (const unsigned int i : {0U, n - 2})
      {
        const scene::Bar &bar = system.bars.bars()[i];
        const Vector3     between =
            system.world.frames[bar.second].position - system.world.frames[bar.first].position;
        ends += std::abs(between[1]) / between.norm() * system.bars.tension()[i];
      }
    ratio("force of the shoe across the string over that of the two ends", force[1], ends, 4);
    verdict("the shoe has pressed the string aside by 5 to 50 mm",
            hub.angle * 0.2 < -5e-3 && hub.angle * 0.2 > -50e-3);
    std::cout << "  pressed aside " << std::fixed << std::setprecision(1) << -1e3 * hub.angle * 0.2
              << " mm\n"
              << std::defaultfloat;
  }

  // a rail beside a drum that turns
  {
    scene::Scene scene  = empty_scene();
    scene.loads.gravity = g;
    scene.bodies        = {
               lump(mass, vector(0., 1e-3, 0.), vector(0.5, 0., 0.)),
               body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3()),
               ground()};
    turn(scene, 1, std::make_shared<functions::Constant>(10.)); // in vain
    turn(scene, 2, std::make_shared<functions::Constant>(10.));
    scene.surfaces.push_back(on_surface(
        plane(1, vector(0., 1., 0.)), {1e5, 50., 0.1, 1e5, 50.}, {{0, Point<3>(), 1e-3, 0}}));
    dynamics::System system(scene, false);
    advance(system, 20000, 1e-5, []() {});
    verdict("the rail stands still, the drum has turned",
            system.world.frames[1].rotation[0][0] == 1. &&
                std::abs(system.world.hubs[1].angle - 2.) < 1e-9);
    ratio("what slides on the rail is braked by mu g",
          system.world.frames[0].velocity[0],
          0.5 - 0.1 * g * 0.2,
          3);
  }
}
