// SPDX-License-Identifier: LGPL-2.1-or-later
// The prescribed hub follows its program exactly; the load torque follows its curve; a hub that the
// torque alone pulls moves as the closed form says.
#include "../support/scenes.h"

using namespace test;

namespace
{
/// A kind of function that the program does not know: amplitude sin(order x).
struct Sine : functions::Function
{
  double value(const double x) const override { return 3. * std::sin(200. * x); }
  double derivative(const double x) const override { return 600. * std::cos(200. * x); }
  double integral(const double from, const double to) const override
  {
    return 0.015 * (std::cos(200. * from) - std::cos(200. * to));
  }
  double largest(double, double) const override { return 3.; }
  double steepest(double, double) const override { return 600.; }
};
} // namespace

int main()
{
  const double full = 120.74, ramp = 5e-3, dt = 0.25e-6;
  for (const int sense : {1, -1})
    for (const auto ramp_kind : {parameters::SpeedRamp::linear, parameters::SpeedRamp::cosine})
      {
        scene::Scene scene = empty_scene();
        turn(scene,
             0,
             std::make_shared<functions::Ramp>(full,
                                               0.,
                                               ramp,
                                               ramp_kind == parameters::SpeedRamp::cosine ?
                                                   functions::Rise::cosine :
                                                   functions::Rise::linear),
             sense);
        scene.bodies = {ground()};
        dynamics::System system(scene, false);
        double           worst_angle = 0., worst_speed = 0.;
        advance(system, 40000, dt, [&]() {
          const double t = system.world.time, s = std::min(t / ramp, 1.);
          double       speed = full * s, angle = full * ramp * 0.5 * s * s;
          if (ramp_kind == parameters::SpeedRamp::cosine)
            {
              speed = full * 0.5 * (1. - std::cos(dealii::numbers::PI * s));
              angle = full * ramp *
                      (0.5 * s - std::sin(dealii::numbers::PI * s) / (2. * dealii::numbers::PI));
            }
          angle += t > ramp ? full * (t - ramp) : 0.;
          const Frame &frame = system.world.frames[0];
          worst_speed        = std::max(
              worst_speed, std::abs(sense * system.world.hubs[0].speed / full - speed / full));
          worst_angle =
              std::max(worst_angle,
                       std::abs(std::sin(std::atan2(frame.rotation[1][0], frame.rotation[0][0]) -
                                         sense * angle)));
        });
        verdict((sense > 0 ? "counter-clockwise, " : "clockwise, ") + text_of(ramp_kind) +
                    ": speed to 1e-9, angle to 1e-12 rad",
                worst_speed < 1e-9 && worst_angle < 1e-12);
      }

  // What is defined above turns the driver to and fro as any other function.
  scene::Scene to_and_fro = empty_scene();
  turn(to_and_fro, 0, std::make_shared<Sine>());
  to_and_fro.bodies = {ground()};
  dynamics::System swinging(to_and_fro, false);
  double           worst_swing = 0.;
  advance(swinging, 20000, 1e-6, [&]() {
    const double angle = 0.015 * (1. - std::cos(200. * swinging.world.time));
    worst_swing        = std::max(worst_swing, std::abs(swinging.world.hubs[0].angle - angle));
  });
  verdict("to and fro: angle to 1e-12 rad", worst_swing < 1e-12);

  // Load torque growing linearly over the angle is a torsion spring until 0.03 rad.
  scene::Scene               scene = empty_scene();
  parameters::Loads          loads;
  const parameters::Sprocket driven{"driven", parameters::Role::driven, 42};
  loads.driver_speed      = 0.;
  loads.resisting_torque  = 150.;
  loads.torque_ramp_angle = 0.03;
  scene.shafts            = {{0, 1, drive::make_program(driven, loads, 0., false)}};
  scene.bodies            = {ground()};
  scene.bodies[0].mount   = scene::Mount::revolute();
  scene.bodies[0].inertia = vector(1., 1., 9.88e-3);
  const double w          = std::sqrt(150. / 0.03 / 9.88e-3);
  scene.bodies[0].initial.angular_velocity[2] = 0.02 * w; // swings to 0.02 rad
  dynamics::System system(scene, false);
  const double     quarter = 0.5 * dealii::numbers::PI / w;
  advance(system, 4000, quarter / 4000, []() {});
  ratio("swing of the loaded hub", system.world.hubs[0].angle, 0.02);
  ratio("torque there", -system.loads.torque(0), 100.);
  ratio("work against the torque",
        system.world.ledger.resisting_work,
        0.5 * 150. / 0.03 * 0.02 * 0.02);
  double worst = 0.;
  for (double angle = -0.01; angle < 0.1; angle += 1e-4)
    worst = std::max(worst,
                     std::abs(scene.shafts[0].program.resisting_torque(angle, 0., 0.) -
                              150. * std::min(std::max(angle / 0.03, 0.), 1.)));
  verdict("curve as prescribed to 1e-9", worst < 1e-9 * 150.);

  // 150 N m against the hub for 1 ms, then 300 N m with it: one constant torque after the other.
  loads.torque_ramp_angle = 0.;
  loads.torque_step_time  = 1e-3;
  loads.torque_after_step = -300.;
  scene.shafts            = {{0, 1, drive::make_program(driven, loads, 0., false)}};
  scene.bodies[0].initial.angular_velocity[2] = 20.;
  const double     inertia                    = scene.bodies[0].inertia[2];
  dynamics::System reversed(scene, false);
  advance(reversed, 4000, 0.5e-6, []() {});
  const double first = 20. - 150. / inertia * 1e-3;
  ratio("speed 1 ms after the torque was reversed",
        reversed.world.hubs[0].speed,
        first + 300. / inertia * 1e-3,
        3);
  verdict("energy closes over the step to 1e-6",
          std::abs(reversed.world.ledger.imbalance()) < 1e-6 * reversed.world.ledger.initial);
}
