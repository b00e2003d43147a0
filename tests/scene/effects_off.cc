// SPDX-License-Identifier: LGPL-2.1-or-later
// An effect that is off has no object, no coefficient and no row in the timing table; one that is
// on has them.
#include "../support/decided.h"
#include "../support/scenes.h"

using namespace test;

namespace
{
void show(const std::string &what, const Parameters &parameters)
{
  const scene::Scene scene = scene_of(parameters);
  dynamics::System   system(scene, false);
  advance(system, 3, 1e-7, []() {});

  double friction = 0., damping = 0.;
  for (const scene::ToothFamily &teeth : scene.teeth)
    {
      friction += teeth.law.friction;
      damping += teeth.law.damping;
    }
  std::cout << what << ":\n  on:";
  for (const model::Decision &effect : scene.effects)
    if (effect.on)
      std::cout << ' ' << effect.name() << ',';
  std::cout << "\n  bars " << scene.bars.size() << ", bore pairs "
            << (scene.bores.empty() ? 0 : scene.bores[0].pairs.size() + scene.bores[1].pairs.size())
            << ", meshes " << scene.parts.size() << ", rotations " << system.world.rotations.size()
            << ", spins " << system.world.spins.size() << (friction > 0. ? ", friction" : "")
            << (damping > 0. ? ", contact damping" : "")
            << (!scene.bars.empty() && scene.bars[0].damping > 0. ? ", bar damping" : "")
            << (scene.loads.gravity != 0. ? ", gravity" : "")
            << (scene.loads.drag != 0. ? ", drag" : "") << "\n  timing rows:";
  for (const PhaseTimer::Row &row : system.timer.rows())
    std::cout << ' ' << row.name << ',';
  std::cout << '\n';
}
} // namespace

int main()
{
  Parameters parameters;
  show("simple, everything", parameters);
  parameters.effects.friction          = parameters.effects.contact_damping =
      parameters.effects.chain_damping = parameters.effects.gravity = parameters::Switch::off;
  parameters.output.field_interval                                  = 0.;
  show("simple, all off", parameters);
  parameters.model.fidelity = "layered";
  parameters.loads.drag     = 10.;
  show("layered, drag only", parameters);

  // coefficients of interfaces that are not there, or that others overrule, switch nothing on
  parameters.model.fidelity                = "simple";
  parameters.effects.friction              = parameters::Switch::automatic;
  parameters.loads.drag                    = 0.;
  parameters.contact.roller_tooth_friction = 0.;
  show("simple, teeth without friction", parameters);
  parameters.model.fidelity               = "layered";
  parameters.contact.roller_bush_friction = parameters.contact.bush_pin_friction = 0.;
  show("layered, no interface with friction", parameters);
}
