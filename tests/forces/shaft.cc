// SPDX-License-Identifier: LGPL-2.1-or-later
// Couplings and bearings on their own. Two inertias on a coupling vibrate with
// sqrt(k (1/J1 + 1/J2)), one behind which a motor turns with sqrt(k / J1); a wheel on a bearing
// with sqrt(k/m) along each axis, while it turns as it did; dampers let them decay as exp(-zeta
// omega t); a constant torque and a constant force end in their static twist and deflection; a
// weight bends nothing; energies balance; and critical time steps are those of these masses on
// these springs, also of a contact with a wheel that moves on its bearing; an impact gives it its
// momentum.
#include "../support/scenes.h"

#include <chaindrive/contact/drum.h>
#include <chaindrive/forces/shaft.h>
#include <chaindrive/functions/function.h>

using namespace test;
using dealii::numbers::PI;

namespace
{
constexpr double j1 = 2e-3, j2 = 5e-3, k = 400., m = 3., kx = 2e6, ky = 5e6;

void name_wheel(scene::Scene &scene)
{
  scene::Sprocket sprocket{};
  sprocket.name = sprocket.title = "wheel";
  scene.drive.sprockets          = {sprocket};
}

/// A wheel, body 0, and behind its coupling body 1: a motor or a machine.
scene::Scene coupled(const bool motor, const double damping, const double torque)
{
  scene::Scene scene = empty_scene();
  for (const bool behind : {false, true})
    scene.bodies.push_back(body(scene::Motion::rigid,
                                behind && motor ? scene::Mount::motor() : scene::Mount::revolute(),
                                1.,
                                vector(1., 1., behind ? j2 : j1),
                                Vector3()));
  scene.couplings.push_back({0, 0, 1, 1, k, damping, torque});
  return scene;
}

/// A wheel, body 0, on bodies 1 and 2, which carry it along x and y.
scene::Scene on_bearing(const std::array<double, 2> &damping, const std::array<double, 2> &start)
{
  scene::Scene scene = empty_scene();
  scene.bodies       = {
            body(scene::Motion::rigid, scene::Mount::revolute(), m, vector(1., 1., j1), Vector3()),
            body(scene::Motion::rigid,
           scene::Mount::prismatic(vector(1., 0., 0.)),
           m,
           vector(1., 1., 1.),
           Vector3()),
            body(scene::Motion::rigid,
           scene::Mount::prismatic(vector(0., 1., 0.)),
           m,
           vector(1., 1., 1.),
           Vector3())};
  scene.bodies[0].mount.carrier = 2;
  scene.bodies[2].mount.carrier = 1;
  scene.bearings.push_back({0, {{1, 2}}, {{kx, ky}}, damping, start, 0.});
  return scene;
}

/// The first @p n times at which @p value of the system goes through zero.
template <typename Value>
std::vector<double>
zeros(dynamics::System &system, const unsigned int n, const double dt, const Value &value)
{
  std::vector<double> found;
  double              before = value();
  while (found.size() < n && system.world.time < 10.)
    advance(system, 1, dt, [&]() {
      const double now = value();
      if (before * now < 0.)
        found.push_back(system.world.time - dt * now / (now - before));
      before = now;
    });
  return found;
}

void couplings()
{
  for (const bool motor : {false, true})
    {
      const std::string name  = motor ? "motor" : "two inertias";
      const double      omega = std::sqrt(k * (1. / j1 + (motor ? 0. : 1. / j2)));
      const double      dt    = 2e-3 / omega;
      {
        scene::Scene scene = coupled(motor, 0., 0.);
        name_wheel(scene);
        scene.bodies[0].initial.angular_velocity = vector(0., 0., 3.);
        dynamics::System system(scene, false);
        ratio(name + ": critical time step", system.critical_time_step(), 2. / omega, 6);
        const auto twist = [&]() { return state_of(scene.couplings[0], system.world).twist; };
        advance(system, 1, dt, []() {});
        const auto times = zeros(system, 9, dt, twist);
        ratio("  frequency", 4. * 2. * PI / (times[8] - times[0]), omega, 5);
        const double energy = 0.5 * j1 * 9.;
        verdict("  energy to 1e-5 of what it had",
                std::abs(system.world.ledger.imbalance()) < 1e-5 * energy);
      }
      {
        // its mean twist is 0.5 rad, as a motor's: what it had is M0 = k 0.3
        scene::Scene scene = coupled(motor, 2. * 0.05 * k / omega, -0.3 * k);
        name_wheel(scene);
        dynamics::System system(scene, false);
        const double     start = state_of(scene.couplings[0], system.world).twist;
        ratio("  twist at the start", start, 0.3, 6);
        advance(system, std::lround(10. / omega / dt), dt, []() {});
        const CouplingState now = state_of(scene.couplings[0], system.world);
        const double        own = std::sqrt(1. - 0.05 * 0.05);
        const double size = std::hypot(now.twist, (now.speed / omega + 0.05 * now.twist) / own);
        ratio("  decay in ten radians", size, 0.3 / own * std::exp(-0.5), 4);
        const double lost = 0.5 * k * 0.09 - 0.5 * k * now.twist * now.twist -
                            0.5 * k * std::pow(now.speed / omega, 2);
        ratio("  lost", *system.forces[0]->lost(), lost, 4);
        ratio("  and in the ledger", system.world.ledger.spring_damping, lost, 4);
      }
    }
  // a motor turns on, a torque holds back: the twist that it ends with, and the work of both
  scene::Scene scene = coupled(true, 2. * 0.3 * std::sqrt(k * j1), 0.);
  name_wheel(scene);
  turn(scene, 1, std::make_shared<const functions::Constant>(20.));
  for (const unsigned int b : {0U, 1U})
    scene.bodies[b].initial.angular_velocity = vector(0., 0., 20.);
  scene.couplings[0].sense = -1;
  drive::ShaftProgram load;
  load.torque = std::make_shared<const functions::Constant>(8.);
  scene.shafts.push_back({0, 1, load});
  dynamics::System system(scene, false);
  advance(system, 40000, 1e-5, []() {});
  const CouplingState now = state_of(scene.couplings[0], system.world);
  ratio("static twist under a load", now.twist, 8. / k, 6);
  ratio("  torque", now.torque(), 8., 6);
  ratio("  of the motor", system.loads.torque(1), 8., 6);
  verdict("  energy to 1e-6 of the work",
          std::abs(system.world.ledger.imbalance()) < 1e-6 * system.world.ledger.drive_work);
}

void bearings()
{
  const std::array<double, 2> stiffness{{kx, ky}};
  for (const unsigned int d : {0U, 1U})
    {
      const double omega = std::sqrt(stiffness[d] / m), dt = 2e-3 / omega;
      {
        std::array<double, 2> start{};
        start[d]           = 1e-4;
        scene::Scene scene = on_bearing({}, start);
        name_wheel(scene);
        scene.bodies[0].initial.angular_velocity = vector(0., 0., 7.);
        dynamics::System system(scene, false);
        const auto       way   = [&]() { return state_of(scene.bearings[0], system.world).way[d]; };
        const auto       times = zeros(system, 9, dt, way);
        ratio(d == 0 ? "bearing along x: frequency" : "bearing along y: frequency",
              4. * 2. * PI / (times[8] - times[0]),
              omega,
              5);
        Vector3 from;
        from[d] = 1e-4;
        verdict("  the wheel is where its bearing is, and turns as it did",
                std::abs(system.world.frames[0].position[d] + from[d] - way()) < 1e-16 &&
                    std::abs(system.world.frames[0].position[1 - d]) < 1e-16 &&
                    std::abs(system.world.hubs[0].speed - 7.) < 1e-12);
        verdict("  energy to 1e-5 of what the spring had",
                std::abs(system.world.ledger.imbalance()) < 1e-5 * 0.5 * stiffness[d] * 1e-8);
      }
      {
        std::array<double, 2> start{}, damping{};
        start[d]           = 1e-4;
        damping[d]         = 2. * 0.05 * std::sqrt(stiffness[d] * m);
        scene::Scene scene = on_bearing(damping, start);
        name_wheel(scene);
        dynamics::System system(scene, false);
        advance(system, std::lround(10. / omega / dt), dt, []() {});
        const BearingState now = state_of(scene.bearings[0], system.world);
        const double       own = std::sqrt(1. - 0.05 * 0.05);
        ratio("  decay in ten radians",
              std::hypot(now.way[d], (now.speed[d] / omega + 0.05 * now.way[d]) / own),
              1e-4 / own * std::exp(-0.5),
              4);
        ratio("  lost",
              *system.forces[0]->lost(),
              0.5 * stiffness[d] * (1e-8 - std::pow(now.way[d], 2)) -
                  0.5 * m * std::pow(now.speed[d], 2),
              4);
      }
    }
  {
    scene::Scene scene = on_bearing({}, {});
    name_wheel(scene);
    dynamics::System system(scene, false);
    ratio("critical time step of both", system.critical_time_step(), 2. * std::sqrt(m / ky), 6);
  }
  {
    // its weight has bent it already
    scene::Scene scene       = on_bearing({}, {});
    scene.loads.gravity      = 9.81;
    scene.bearings[0].weight = m * 9.81;
    name_wheel(scene);
    dynamics::System system(scene, false);
    advance(system, 1000, 1e-5, []() {});
    verdict("a weight moves nothing", std::abs(system.world.frames[0].position[1]) < 1e-15);
  }
  for (const unsigned int d : {0U, 1U})
    {
      // a lump flies against a wheel that nothing holds: it gets its share of the momentum
      const double light = 0.3;
      scene::Scene scene = on_bearing({}, {});
      name_wheel(scene);
      scene.bearings[0].stiffness = {};
      Vector3 along;
      along[d] = 1.;
      scene.bodies.push_back(lump(light, -(20e-3 + 1e-4) * along, 2. * along));
      scene.surfaces.push_back(on_surface(std::make_shared<const contact::Drum>(0, 15e-3),
                                          {1e7, 0., 0., 0., 0.},
                                          {{3, dealii::Point<3>(), 5e-3, 0}}));
      dynamics::System system(scene, false);
      advance(system, 4000, 1e-6, []() {});
      ratio(d == 0 ? "speed after an impact along x" : "speed after an impact along y",
            state_of(scene.bearings[0], system.world).speed[d],
            2. * 2. * light / (light + m),
            5);
    }
  // a lump leans on the wheel by its weight, from above: the bearing yields by m g / k
  for (const bool planar : {false, true})
    {
      const double lean = 0.4, stiff = 1e7, damped = 2. * 0.5 * std::sqrt(stiff * lean);
      scene::Scene scene = on_bearing({{2e3, 4e3}}, {});
      name_wheel(scene);
      scene.loads.gravity      = 9.81;
      scene.bearings[0].weight = m * 9.81;
      scene.bodies.push_back(lump(lean, vector(0., 20e-3, 0.)));
      scene.surfaces.push_back(on_surface(std::make_shared<const contact::Drum>(0, 15e-3),
                                          {stiff, damped, 0., 0., 0.},
                                          {{3, dealii::Point<3>(), 5e-3, 0}}));
      scene.planar = planar;
      dynamics::System system(scene, false);
      if (!planar)
        {
          // the lump, the wheel on the bearing and the contact between them
          // what moves most easily is the wheel, along x or y, not its rim
          const double a = (stiff + ky) / m, b = stiff / lean, c = stiff * stiff / (m * lean);
          const double largest             = 0.5 * (a + b + std::sqrt((a - b) * (a - b) + 4. * c));
          scene::Scene undamped            = scene;
          undamped.bodies[0].inertia[2]    = 1e3;
          undamped.surfaces[0].law.damping = 0.;
          undamped.bearings[0].damping     = {};
          ratio("critical time step of a contact with the wheel",
                dynamics::System(undamped, false).critical_time_step(),
                2. / std::sqrt(largest),
                6);
        }
      advance(system, 100000, 2e-6, []() {});
      const BearingState now = state_of(scene.bearings[0], system.world);
      ratio(planar ? "static deflection in the plane" : "static deflection",
            now.way[1],
            -lean * 9.81 / ky,
            5);
      ratio("  force of the bearing", now.elastic[1], lean * 9.81, 5);
      verdict("  energy to 1e-4 of what gravity gave",
              std::abs(system.world.ledger.imbalance()) <
                  1e-4 * lean * 9.81 * (lean * 9.81 / ky + lean * 9.81 / stiff));
    }
}
} // namespace

int main()
{
  couplings();
  bearings();
}
