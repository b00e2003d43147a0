// SPDX-License-Identifier: LGPL-2.1-or-later
// Terms of a load act as their closed forms say on a hub that nothing else holds: a torque that
// grows with the speed or its square slows it down, whichever way it turns; waves over its angle
// give back what they take; a table over time is an impulse. The energy balance knows all of it.
#include "../support/scenes.h"

using namespace test;
using functions::Of;
using functions::Variable;

namespace
{
constexpr double inertia = 9.88e-3, start = 2e-3; // kg m2, s

/// A hub that turns with @p speed [rad/s] against @p terms.
scene::Scene hub(const std::vector<functions::Term> &terms, const double speed, const int sense)
{
  scene::Scene scene = empty_scene();
  scene.start_time   = start;
  drive::ShaftProgram program;
  program.terms                               = terms;
  scene.shafts                                = {{0, sense, program}};
  scene.bodies                                = {ground()};
  scene.bodies[0].mount                       = scene::Mount::revolute();
  scene.bodies[0].inertia                     = vector(1., 1., inertia);
  scene.bodies[0].initial.angular_velocity[2] = sense * speed;
  return scene;
}

void balance(const dynamics::System &system)
{
  const Ledger &ledger = system.world.ledger;
  verdict("  energy closes to 1e-7 of what there was",
          std::abs(ledger.imbalance()) < 1e-7 * ledger.initial);
}
} // namespace

int main()
{
  const double speed = 40., time = 0.05;
  const auto   steps = static_cast<unsigned long>(time / 1e-6 + 0.5);
  for (const int sense : {1, -1})
    {
      std::cout << (sense > 0 ? "counter-clockwise" : "clockwise") << '\n';
      const double     c = 0.3;
      dynamics::System linear(
          hub({{Variable::speed, std::make_shared<functions::Resistance>(c, 0.)}}, speed, sense),
          false);
      advance(linear, steps, 1e-6, []() {});
      const double left = speed * std::exp(-c * time / inertia);
      ratio("  speed against a linear torque", sense * linear.world.hubs[0].speed, left, 4);
      ratio("  its work",
            linear.world.ledger.resisting_work,
            0.5 * inertia * (speed * speed - left * left),
            4);
      balance(linear);

      const double     q = 0.02;
      dynamics::System quadratic(
          hub({{Variable::speed, std::make_shared<functions::Resistance>(0., q)}}, speed, sense),
          false);
      advance(quadratic, steps, 1e-6, []() {});
      ratio("  speed against a quadratic torque",
            sense * quadratic.world.hubs[0].speed,
            speed / (1. + q * speed * time / inertia),
            4);
      balance(quadratic);

      const double     a = 6., order = 3., phase = 0.4;
      dynamics::System waves(hub({{Variable::angle,
                                   std::make_shared<functions::Harmonics>(
                                       std::vector<functions::Harmonic>{{order, a, phase}})}},
                                 speed,
                                 sense),
                             false);
      advance(waves, steps, 1e-6, []() {});
      const double turned = sense * waves.world.hubs[0].angle;
      const double taken  = a / order * (std::sin(order * turned + phase) - std::sin(phase));
      ratio("  speed against waves over the angle",
            sense * waves.world.hubs[0].speed,
            std::sqrt(speed * speed - 2. * taken / inertia),
            5);
      balance(waves);

      // 0, 4, 0 N m at 10, 20, 40 ms: the area below it is that of a triangle where slopes at the
      // points are 0 or those of the chords
      const auto table = std::make_shared<functions::Table>(
          std::vector<double>{start + 0.01, start + 0.02, start + 0.04},
          std::vector<double>{0., 4., 0.});
      dynamics::System impulse(hub({{Variable::time, table}}, speed, sense), false);
      advance(impulse, steps, 1e-6, []() {});
      ratio("  speed lost to a table over time",
            speed - sense * impulse.world.hubs[0].speed,
            table->integral(start, start + time) / inertia,
            6);
      balance(impulse);
    }

  // one that turns backwards is slowed down as well
  dynamics::System backwards(
      hub({{Variable::speed, std::make_shared<functions::Resistance>(0.3, 0.01)}}, -speed, 1),
      false);
  advance(backwards, steps, 1e-6, []() {});
  verdict("backwards it is slowed down, and energy is taken",
          backwards.world.hubs[0].speed > -speed && backwards.world.hubs[0].speed < 0. &&
              backwards.world.ledger.resisting_work > 0.);

  // what a drive is designed for
  drive::ShaftProgram program;
  program.torque = std::make_shared<functions::Ramp>(50., 0., 0.03);
  program.terms  = {
       {Variable::speed, std::make_shared<functions::Resistance>(0.1, 0.01)},
       {Variable::angle,
        std::make_shared<functions::Harmonics>(std::vector<functions::Harmonic>{{2., 7., 0.}})},
       {Variable::time, std::make_shared<functions::Ramp>(10., 0., 1.)}};
  const double revolutions = 2. * dealii::numbers::PI / 20. * 3.; // s, three at 20 rad/s
  ratio("mean torque over whole revolutions",
        program.mean_torque(0., revolutions, 20.),
        50. + 2. + 4. +
            10. *
                (0.5 * std::min(revolutions, 1.) * std::min(revolutions, 1.) +
                 std::max(revolutions - 1., 0.)) /
                revolutions,
        10);
  verdict("no torque is above its bound",
          program.largest_torque(0., 2., 20.) >= 50. + 2. + 4. + 7. + 10.);
}
