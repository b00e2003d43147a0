// SPDX-License-Identifier: LGPL-2.1-or-later
// One link of a running chain that is not like the others: a bar a thousand times as stiff, a
// joint that hardly turns. The step is voted for anew, energy closes, and what hubs give is what
// bodies get.
#include "../support/scenes.h"

#include <chaindrive/dynamics/guard.h>
#include <chaindrive/scene/build.h>

using namespace test;

namespace
{
constexpr unsigned int stiff = 3; // it goes round the driver

scene::Scene make_scene(const bool layered, const bool stiff_link)
{
  Parameters parameters;
  parameters.model.fidelity        = layered ? "layered" : "simple";
  parameters.output.field_interval = 0.;
  parameters.loads.ramp_time       = layered ? 1e-3 : 0.2e-3;
  scene::Scene scene = scene::build_scene(parameters, drive::make_drive(parameters), {"."});
  if (stiff_link && !layered)
    scene.bars[stiff].stiffness *= 1e3;
  if (stiff_link && layered)
    for (std::size_t f = 0; f < scene.bores.size(); ++f)
      if (scene.bores[f].name == "bush-pin")
        {
          scene::BoreFamily own = scene.bores[f]; // of this joint alone
          own.pairs.clear();
          std::vector<scene::BorePair> others;
          for (const scene::BorePair &pair : scene.bores[f].pairs)
            (pair.slave.joint == stiff ? own.pairs : others).push_back(pair);
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
  const Vector3      before = contact::axis_of(world.frames[n + stiff - 1], 0),
                after       = contact::axis_of(world.frames[n + stiff], 0);
  return std::acos(std::min(1., before * after));
}
} // namespace

int main()
{
  for (const bool layered : {false, true})
    {
      const scene::Scene     ordinary = make_scene(layered, false);
      const dynamics::System like_others(ordinary, false);
      const scene::Scene     scene = make_scene(layered, true);
      dynamics::System       system(scene, false);
      const World           &world = system.world;
      const double           limit = system.stable_step_limit(), dt = 0.14 * limit;
      dynamics::Guard        guard(scene, system, 0.05, 1e-3 * scene.nominal_energy());
      const double           start = layered ? bend(world) : 0.;
      double                 worst = 0., turned = 0.;
      unsigned long          step = 0;
      advance(system, static_cast<unsigned long>((layered ? 5e-3 : 1e-3) / dt), dt, [&]() {
        worst = std::max(worst, std::abs(world.ledger.imbalance()));
        guard.check(system, ++step, dt);
        if (layered)
          turned = std::max(turned, std::abs(bend(world) - start));
      });
      std::cout << (layered ? "layered, a joint of friction 50\n" :
                              "simple, a bar 1e3 times as stiff\n");
      verdict("  smaller stable step", limit < like_others.stable_step_limit() || layered);
      verdict("  imbalance below 0.1 % of the drive work", worst < 1e-3 * world.ledger.drive_work);
      verdict("  momentum closes to 1e-9", guard.largest_momentum_error() < 1e-9);
      verdict("  the driver turned the driven sprocket", world.hubs[1].angle > 5e-3);
      if (layered)
        verdict("  the joint turned by less than a tenth of a tooth", turned < 0.1 * 0.42);
    }
}
