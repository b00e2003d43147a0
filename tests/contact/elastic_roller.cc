// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic roller falls into a gap of a rigid sprocket at the speed of an engagement, without
// friction and damping: energy is kept, its momentum changes by the impulse of the contact, the
// force is symmetric about the gap; the displacement-driven search misses nothing and gives the
// same motion as one at every step. With friction, a spinning roller gains momentum along the tooth
// and loses spin.
#include "../support/scenes.h"

#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/part.h>

using namespace test;

namespace
{
scene::Scene make_scene(const double friction, const double spin)
{
  scene::Scene scene = empty_scene();
  const auto   chain = drive::make_chain(parameters::Chain());
  const auto   form  = std::make_shared<const drive::ToothForm>(
      drive::make_tooth_form(15, chain, parameters::Sprockets(), 0));
  const auto part = std::make_shared<const mesh::Part>(
      mesh::make_roller(chain, scene.material.density, mesh::RollerGrid(1, 32, 4)));
  scene.parts[scene::Kind::roller] = part;

  // 5 um above the bottom of gap 0
  const double start = 0.5 * form->root_diameter + 0.5 * chain.roller_diameter + 5e-6;
  scene.bodies       = {body(scene::Motion::elastic,
                       scene::Mount::free(),
                       part->meshed.mass,
                       vector(1., 1., 1.),
                       vector(start, 0.),
                       vector(-1.3, 0.)),
                        ground()};
  scene.bodies[0].initial.angular_velocity = vector(0., 0., spin);
  const double      wall                   = 0.5 * (chain.roller_diameter - chain.roller_bore);
  scene::ContactLaw law;
  law.stiffness = 0.5 * scene.material.youngs_modulus / wall;
  if (friction > 0.)
    {
      law.friction             = friction;
      law.tangential_stiffness = 0.8 * law.stiffness;
    }
  scene::ToothFamily teeth;
  teeth.name          = "roller-driver";
  teeth.sprocket      = 1;
  teeth.form          = form;
  teeth.teeth         = 15;
  teeth.outer_radius  = 0.5 * form->outside_diameter;
  teeth.half_width    = 3.6e-3;
  teeth.law           = law;
  teeth.slaves        = {{0, dealii::Point<3>(), 0.5 * chain.roller_diameter, 0}};
  teeth.elastic       = true;
  teeth.slave_surface = mesh::roller_outside;
  scene.teeth         = {teeth};
  return scene;
}

/// What happens in 150 us.
struct Outcome
{
  Vector3       impulse, velocity;
  double        worst = 0., kinetic = 0., mass = 0., peak = 0., friction = 0.;
  unsigned long missed = 0;
};

Outcome run(const scene::Scene &scene, const bool every_step)
{
  dynamics::System system(scene, every_step);
  const double     dt = 0.5 * system.critical_time_step();
  Outcome          outcome;
  outcome.mass    = system.world.copies[0].mass;
  outcome.kinetic = system.world.ledger.initial;
  advance(system, static_cast<unsigned long>(150e-6 / dt), dt, [&]() {
    const contact::Record &record = system.contacts.families()[0]->records()[0];
    outcome.impulse += dt * record.force;
    outcome.peak  = std::max(outcome.peak, record.force.norm());
    outcome.worst = std::max(outcome.worst, std::abs(system.world.ledger.imbalance()));
  });
  outcome.velocity = system.world.frames[0].velocity;
  outcome.friction = system.world.ledger.friction;
  outcome.missed   = system.contacts.n_missed();
  return outcome;
}
} // namespace

int main()
{
  const Outcome driven = run(make_scene(0., 0.), false), every = run(make_scene(0., 0.), true);
  verdict("imbalance below 0.5 % of the energy", driven.worst < 5e-3 * driven.kinetic);
  verdict("change of momentum is the impulse to 1e-3",
          (driven.mass * (driven.velocity - vector(-1.3, 0.)) - driven.impulse).norm() <
              1e-3 * driven.impulse.norm());
  verdict("impulse along the gap's middle to 1e-9",
          std::abs(driven.impulse[1]) + std::abs(driven.impulse[2]) < 1e-9 * driven.impulse[0]);
  std::cout << "rebound " << std::fixed << std::setprecision(2) << driven.velocity[0] / 1.3
            << " of the speed, the rest rings; peak force over that of a rigid roller on its ring: "
            << std::setprecision(1) << driven.peak / (1.3 * std::sqrt(2.2e7 * driven.mass)) << '\n';
  verdict("the same with a search at every step, to 1e-9",
          (driven.velocity - every.velocity).norm() < 1e-9 * every.velocity.norm());
  verdict("no contact missed", driven.missed == 0 && every.missed == 0);

  const Outcome spinning = run(make_scene(0.2, 500.), false);
  verdict("friction: imbalance below 0.5 % of the energy",
          spinning.worst < 5e-3 * spinning.kinetic);
  std::cout << "friction on the spinning roller: impulse along the tooth over normal "
            << std::setprecision(3) << std::abs(spinning.impulse[1]) / spinning.impulse[0]
            << " of at most 0.2; loss " << spinning.friction / spinning.kinetic * 100.
            << " % of the energy\n";
}
