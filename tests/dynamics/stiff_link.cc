// SPDX-License-Identifier: LGPL-2.1-or-later
// One link of a running chain that is not like the others: a bar a thousand times as stiff, whose
// two lumps decide the step, and a joint in which the pin sticks. It bends less than the same joint
// with the friction of the others, but bend it does: whatever the coefficient, a pin with clearance
// rolls up the side of its bush and comes off when the moment is tension times radius. Energy
// closes, and what hubs give is what bodies get.
#include "../support/decided.h"
#include "../support/scenes.h"

#include <chaindrive/dynamics/guard.h>

#include <deal.II/base/mpi.h>

using namespace test;

namespace
{
/// Of @p n_joints, the one that comes to the driver next: the chain bends there.
unsigned int stiff(const unsigned int n_joints) { return n_joints - 1; }

scene::Scene make_scene(const bool layered, const bool stiff_link)
{
  Parameters parameters;
  parameters.model.fidelity                 = layered ? "layered" : "simple";
  parameters.output.field_interval          = 0.;
  parameters.contact.roller_tooth_stiffness = 2e7; // the bar is much stiffer
  parameters.loads.ramp_time                = 0.2e-3;
  if (layered)
    // the joint is loaded from the first moment on
    parameters.drive.layout.start = parameters::Start::settled;
  scene::Scene scene = scene_of(parameters);
  if (stiff_link && !layered)
    scene.bars[stiff(scene.drive.n_joints)].stiffness *= 1e3;
  if (stiff_link && layered)
    for (std::size_t f = 0; f < scene.bores.size(); ++f)
      if (scene.bores[f].name == "bush-pin")
        {
          scene::BoreFamily own = scene.bores[f]; // of this joint alone
          own.pairs.clear();
          std::vector<scene::BorePair> others;
          for (const scene::BorePair &pair : scene.bores[f].pairs)
            (pair.slave.joint == stiff(scene.drive.n_joints) ? own.pairs : others).push_back(pair);
          own.law.friction     = 50.;
          scene.bores[f].pairs = others;
          scene.bores.push_back(own);
          break;
        }
  return scene;
}

/// Angle between the axes of the links on both sides of the joint, rad.
double bend(const World &world)
{
  const unsigned int n      = (world.n_bodies() - 2) / 2;
  const Vector3      before = contact::axis_of(world.frames[n + stiff(n) - 1], 0),
                after       = contact::axis_of(world.frames[n + stiff(n)], 0);
  return std::acos(std::min(1., before * after));
}

struct Outcome
{
  double limit = 0., worst = 0., momentum = 0., driven = 0.; ///< s, J, 1, rad
  double bent = 0.; ///< most that the joint has turned, rad
};

Outcome run(const bool layered, const bool stiff_link)
{
  const scene::Scene scene = make_scene(layered, stiff_link);
  dynamics::System   system(scene, false);
  const World       &world = system.world;
  Outcome            outcome;
  outcome.limit            = system.critical_time_step();
  const double       dt    = 0.14 * outcome.limit;
  const double       start = layered ? bend(world) : 0.;
  dynamics::Guard    guard(scene, system, 0.05, system.critical_time_step());
  dynamics::Services services(system);
  unsigned long      step = 0;
  advance(system, static_cast<unsigned long>((layered ? 4e-3 : 1e-3) / dt), dt, [&]() {
    outcome.worst = std::max(outcome.worst, std::abs(world.ledger.imbalance()));
    guard.observe(system, ++step, dt, services);
    if (layered)
      outcome.bent = std::max(outcome.bent, std::abs(bend(world) - start));
  });
  outcome.worst /= world.ledger.drive_work;
  outcome.momentum = guard.largest_momentum_error();
  outcome.driven   = world.hubs[1].angle;
  return outcome;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool layered : {false, true})
    {
      const Outcome outcome = run(layered, true);
      std::cout << (layered ? "layered, a joint of friction 50\n" :
                              "simple, a bar 1e3 times as stiff\n");
      verdict("  imbalance below 0.1 % of the drive work", outcome.worst < 1e-3);
      verdict("  momentum closes to 1e-9", outcome.momentum < 1e-9);
      verdict("  the driver turned the driven sprocket", outcome.driven > 5e-3);
      if (!layered)
        {
          const scene::Scene scene = make_scene(false, true);
          const unsigned int k     = stiff(scene.drive.n_joints);
          const double       alone =
              2. / std::sqrt(2. * scene.bars[k].stiffness / scene.bodies[scene.bars[k].first].mass);
          verdict("  critical time step that of its two lumps alone to 1 %",
                  outcome.limit < alone && outcome.limit > 0.99 * alone);
        }
      else
        {
          const Outcome ordinary = run(true, false);
          verdict("  friction's coefficient does not change the critical time step",
                  std::abs(outcome.limit / ordinary.limit - 1.) < 1e-9);
          verdict("  with the friction of the others the joint turns by 0.8 of the pitch angle",
                  ordinary.bent > 0.8 * 2. * dealii::numbers::PI / 15.);
          verdict("  sticking by less than 0.9 of that", outcome.bent < 0.9 * ordinary.bent);
        }
    }
}
