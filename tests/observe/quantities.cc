// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run is not asked for is not there: no quantity, no effect that only it needs, no mesh, no
// memory, no step. Each group alone, in the small drive of elastic bodies and in the layered one.
#include "../support/scenes.h"

#include <chaindrive/observe/observation.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/errors.h>

using namespace test;
using parameters::QuantityGroup;

namespace
{
Parameters small_drive(const std::string &fidelity)
{
  Parameters parameters;
  parameters.drive.n_links                  = 22;
  parameters.drive.sprockets.driver().teeth = parameters.drive.sprockets.driven().teeth = 9;
  parameters.drive.layout.slack                                                         = 1e-4;
  parameters.model.driven_inertia                                                       = 1e-4;
  parameters.loads.resisting_torque                                                     = 20.;
  parameters.model.fidelity                                                             = fidelity;
  return parameters;
}

struct Sizes
{
  std::size_t memory, contacts;
};

Sizes show(const std::string &what, const Parameters &parameters)
{
  const drive::Drive         drive = drive::make_drive(parameters);
  const model::Model         model = model::make_model(parameters, drive);
  const scene::Scene         scene = scene::build_scene(model, drive, {"."});
  dynamics::System           system(scene, false);
  const observe::Observation now(scene, model, system);
  std::cout << what << ":\n  quantities";
  for (const observe::NamedQuantity &item : observe::make_quantities(now))
    std::cout << ", " << item.name << (item.quantity->reads_contacts() ? "" : " (no records)");
  std::cout << "\n  effects";
  for (const model::Decision &decision : scene.effects)
    for (const model::Effect asked : {model::Effect::elastic_links,
                                      model::Effect::elastic_rollers,
                                      model::Effect::elastic_sprocket,
                                      model::Effect::symmetry_model,
                                      model::Effect::fields})
      if (decision.effect == asked && decision.on)
        std::cout << ", " << decision.name();
  std::cout << "\n  groups of elastic bodies " << system.world.n_elastic_groups() << ", meshes "
            << scene.parts.size() << '\n';
  return {system.world.memory_consumption(), system.contacts.memory_consumption()};
}
} // namespace

int main()
{
  for (const std::string fidelity : {"layered", "full"})
    {
      Parameters                     p   = small_drive(fidelity);
      const Sizes                    all = show(fidelity + ", all", p);
      std::map<QuantityGroup, Sizes> sizes;
      for (const auto &[group, name] : parameters::texts_of<QuantityGroup>)
        {
          p.output.quantities = {group};
          sizes[group]        = show(fidelity + ", " + name, p);
        }
      if (fidelity == "layered")
        continue;
      p.output.quantities = {QuantityGroup::tensions, QuantityGroup::plate_stress};
      show("full, tensions and plate stress", p);
      p.output.quantities   = {QuantityGroup::engagements};
      p.model.elastic_links = parameters::ElasticLinks::region_of_interest;
      show("full, engagements, links in the region of interest", p);

      // what auto leaves out is as if it were switched off
      p                                      = small_drive(fidelity);
      p.effects.elastic_rollers              = p.drive.sprockets.driver().elastic =
          p.drive.sprockets.driven().elastic = parameters::Switch::off;
      p.output.field_interval                = 0.;
      const Sizes off                        = show("full, all, switched off", p);
      const Sizes tensions                   = sizes[QuantityGroup::tensions];
      verdict("tensions need less memory than all", tensions.memory < all.memory);
      verdict("and as much as if the rest were switched off",
              tensions.memory == off.memory && tensions.contacts == off.contacts);
      verdict("engagements need half of what all need",
              sizes[QuantityGroup::engagements].memory < 0.6 * all.memory);
    }
}
