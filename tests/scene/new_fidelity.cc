// SPDX-License-Identifier: LGPL-2.1-or-later
// A fidelity that chaindrive does not have, made here and nowhere else: the simple chain on bars
// that are four times as stiff. Its name is one of those that the entry takes, its capabilities
// decide effects, and its bars store four times the energy at the same elongation. One with the
// name of another is refused.
#include "../support/decided.h"
#include "../support/scenes.h"

#include <chaindrive/model/reading.h>
#include <chaindrive/scene/fidelity.h>
#include <chaindrive/utilities/errors.h>

using namespace test;

namespace
{
void build_stiff(const model::Model &model, const drive::Drive &drive, scene::Scene &scene)
{
  scene::Fidelity::builder_of("simple")(model, drive, scene);
  for (scene::Bar &bar : scene.bars)
    bar.stiffness *= 4.;
}

const scene::Fidelity
    stiff({"stiff", "lumped rollers on stiff bars."}, {false, false, false}, &build_stiff);

scene::Scene scene_with(const std::string &fidelity)
{
  return scene_of(model::read_entries({{"Model/Fidelity", fidelity}}).parameters);
}

/// Strain energy of bars when every second roller between the sprockets is moved.
double strain_of(const std::string &fidelity)
{
  scene::Scene scene = scene_with(fidelity);
  for (std::size_t i = 0; i < scene.drive.rollers.size(); i += 2)
    if (!scene.drive.seated[i])
      scene.bodies[scene.drive.rollers[i]].initial.position[1] += 1e-5;
  dynamics::System system(scene, false);
  return system.world.ledger.bar;
}
} // namespace

int main()
{
  std::cout << "fidelities:";
  for (const std::string &name : parameters::fidelities())
    std::cout << ' ' << name;
  std::cout << '\n';
  verdict("its capabilities are asked for",
          !model::read_entries({{"Model/Fidelity", "stiff"}})
               .parameters.model.capabilities()
               .is_elastic);
  bool bars = false;
  for (const model::Decision &effect : scene_with("stiff").effects)
    bars = bars || (effect.effect == model::Effect::chain_bars && effect.on);
  verdict("effects follow from them", bars);
  const double ratio = strain_of("stiff") / strain_of("simple");
  std::cout << "strain energy over that of simple: " << ratio << '\n';
  try
    {
      model::read_entries({{"Model/Fidelity", "stif"}});
      std::cout << "another name: accepted\n";
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
  scene::Fidelity({"full", "another one."}, {false, false, false}, &build_stiff);
  std::cout << AnyRegistry::problems().back() << '\n';
}
