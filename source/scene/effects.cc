// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/effects.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace chaindrive::scene
{
using parameters::ElasticLinks;
using parameters::PlateFaces;
using parameters::Switch;

namespace
{
Effect decide(const std::string &name,
              const Switch       choice,
              const double       coefficient,
              const std::string &coefficient_text)
{
  if (choice == Switch::off)
    return {name, false, "switched off in section Effects"};
  const bool on = coefficient != 0.;
  return {name, on, coefficient_text + (on ? "" : " is zero")};
}

/// The largest friction coefficient of the interfaces that the fidelity of @p p has.
double largest_friction(const Parameters &p)
{
  const parameters::Contact &contact = p.contact;
  const auto                 of      = [&contact](const std::optional<double> &own) {
    return own.value_or(contact.friction_coefficient);
  };
  double largest = of(contact.roller_tooth_friction);
  if (p.model.capabilities().has_clearances)
    largest = std::max({largest, of(contact.roller_bush_friction), of(contact.bush_pin_friction)});
  if (p.model.capabilities().is_elastic && contact.plate_faces == PlateFaces::on)
    largest = std::max(largest, contact.friction_coefficient);
  return largest;
}
} // namespace

std::vector<Effect> decide_effects(const Parameters &p)
{
  const auto [has_clearances, is_elastic] = p.model.capabilities();
  const std::string fidelity              = "fidelity " + text_of(p.model.fidelity) + ": ";
  const double      friction              = largest_friction(p);

  std::vector<Effect> effects;
  effects.push_back({"joint clearances",
                     has_clearances,
                     fidelity + (has_clearances ? "roller, bush and pin are bodies of their own" :
                                                  "roller, bush and pin are one lump")});
  effects.push_back(
      {"chain bars",
       !has_clearances,
       fidelity + (is_elastic     ? "links are made of finite elements" :
                   has_clearances ? "links are rigid, their compliance sits in the joints" :
                                    "plates are elastic bars")});
  effects.push_back(decide(
      "friction", p.effects.friction, friction, "friction coefficient " + to_text(friction)));
  effects.push_back(decide("contact damping",
                           p.effects.contact_damping,
                           p.contact.damping_ratio,
                           "damping ratio " + to_text(p.contact.damping_ratio)));
  Effect chain_damping = decide("chain damping",
                                p.effects.chain_damping,
                                p.model.chain_damping_ratio,
                                "chain damping ratio " + to_text(p.model.chain_damping_ratio));
  if (has_clearances)
    chain_damping = {"chain damping", false, "there are no bars: the joints' contact damping acts"};
  effects.push_back(chain_damping);
  effects.push_back(decide("gravity",
                           p.effects.gravity,
                           p.loads.gravity,
                           "acceleration " + to_text(p.loads.gravity) + " m/s2"));
  effects.push_back(decide(
      "drag", p.effects.drag, p.loads.drag, "coefficient " + to_text(p.loads.drag) + " 1/s"));
  const bool arriving = is_elastic && p.model.elastic_links == ElasticLinks::arriving;
  effects.push_back({"elastic bodies",
                     is_elastic,
                     arriving   ? fidelity + "rollers and links that arrive in the window" :
                     is_elastic ? fidelity + "rollers, inner and outer links" :
                                  "no group of bodies is elastic in this fidelity"});
  const bool elastic_sprockets =
      is_elastic && !arriving && p.model.elastic_sprockets != Switch::off;
  effects.push_back({"elastic sprockets",
                     elastic_sprockets,
                     elastic_sprockets ? fidelity + "rims, held by rigid hubs" :
                     arriving          ? "rigid beside rigid links: Elastic links = arriving" :
                     is_elastic        ? "switched off in section Model" :
                                         "no group of bodies is elastic in this fidelity"});
  if (is_elastic)
    effects.push_back({"plate faces",
                       p.contact.plate_faces == PlateFaces::on,
                       p.contact.plate_faces == PlateFaces::on ?
                           "asked for in section Contact: between elastic links" :
                           "Contact/Plate faces: plates pass through each other"});
  if (is_elastic)
    effects.push_back(
        {"half model",
         p.model.half,
         p.model.half ? "asked for: the middle plane is a plane of symmetry" : "whole bodies"});
  effects.push_back({"fields",
                     p.output.field_interval > 0.,
                     "field interval " + to_text(p.output.field_interval * 1e3) + " ms"});
  return effects;
}

bool is_on(const std::vector<Effect> &effects, const std::string &name)
{
  for (const Effect &effect : effects)
    if (effect.name == name)
      return effect.on;
  throw std::logic_error("no effect is called " + name);
}
} // namespace chaindrive::scene
