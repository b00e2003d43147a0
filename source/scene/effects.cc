// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/needs.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/effects.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace chaindrive::scene
{
using parameters::Decision;
using parameters::Role;
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
  if (parameters::plate_faces(p).on)
    largest = std::max(largest, contact.friction_coefficient);
  return largest;
}
} // namespace

std::vector<Effect> decide_effects(const Parameters &p)
{
  const auto [has_clearances, is_elastic, is_reduced] = p.model.capabilities();
  const std::string fidelity = "fidelity " + text_of(p.model.fidelity) + ": ";
  const double      friction = largest_friction(p);

  std::vector<Effect> effects;
  const auto          add = [&effects](const std::string &name, const Decision &decision) {
    effects.push_back({name, decision.on, decision.reason});
  };
  add("roller-bush clearance", parameters::clearance(p, p.effects.roller_bush_clearance));
  add("bush-pin clearance", parameters::clearance(p, p.effects.bush_pin_clearance));
  effects.push_back(
      {"chain bars",
       !has_clearances,
       fidelity + (is_reduced     ? "links deform by shapes" :
                   is_elastic     ? "links are made of finite elements" :
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
  add("elastic links", parameters::elastic_links(p));
  add("elastic rollers", parameters::elastic_rollers(p));
  add("elastic driver", parameters::elastic_sprocket(p, Role::driver));
  add("elastic driven", parameters::elastic_sprocket(p, Role::driven));
  add("tooth compliance", parameters::tooth_compliance(p));
  add("plate bending", parameters::plate_bending(p));
  add("reduced bodies", parameters::reduced_bodies(p));
  add("column mass scaling", parameters::column_mass_scaling(p));
  add("plate faces", parameters::plate_faces(p));
  add("half model", parameters::half_model(p));
  add("fields", parameters::fields(p));
  add("stress recovery", parameters::stress_recovery(p));
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
