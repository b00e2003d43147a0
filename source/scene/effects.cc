// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/needs.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/effects.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace chaindrive::scene
{
using parameters::Decision;
using parameters::Switch;

namespace
{
struct EffectText
{
  EffectKind  kind;
  const char *text;
};
constexpr EffectText texts[] = {{EffectKind::roller_bush_clearance, "roller-bush clearance"},
                                {EffectKind::bush_pin_clearance, "bush-pin clearance"},
                                {EffectKind::chain_bars, "chain bars"},
                                {EffectKind::friction, "friction"},
                                {EffectKind::contact_damping, "contact damping"},
                                {EffectKind::chain_damping, "chain damping"},
                                {EffectKind::gravity, "gravity"},
                                {EffectKind::drag, "drag"},
                                {EffectKind::elastic_links, "elastic links"},
                                {EffectKind::elastic_rollers, "elastic rollers"},
                                {EffectKind::elastic_sprocket, "elastic"},
                                {EffectKind::tooth_compliance, "tooth compliance"},
                                {EffectKind::plate_bending, "plate bending"},
                                {EffectKind::reduced_bodies, "reduced bodies"},
                                {EffectKind::column_mass_scaling, "column mass scaling"},
                                {EffectKind::plate_faces, "plate faces"},
                                {EffectKind::half_model, "half model"},
                                {EffectKind::fields, "fields"},
                                {EffectKind::stress_recovery, "stress recovery"},
                                {EffectKind::start_up, "start-up"}};

Effect decide(const EffectKind   kind,
              const Switch       choice,
              const double       coefficient,
              const std::string &coefficient_text)
{
  if (choice == Switch::off)
    return {kind, false, "switched off in section Effects"};
  const bool on = coefficient != 0.;
  return {kind, on, coefficient_text + (on ? "" : " is zero")};
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
  const auto          add = [&effects](const EffectKind kind, const Decision &decision) {
    effects.push_back({kind, decision.on, decision.reason});
  };
  add(EffectKind::roller_bush_clearance, parameters::clearance(p, p.effects.roller_bush_clearance));
  add(EffectKind::bush_pin_clearance, parameters::clearance(p, p.effects.bush_pin_clearance));
  effects.push_back(
      {EffectKind::chain_bars,
       !has_clearances,
       fidelity + (is_reduced     ? "links deform by shapes" :
                   is_elastic     ? "links are made of finite elements" :
                   has_clearances ? "links are rigid, their compliance sits in the joints" :
                                    "plates are elastic bars")});
  effects.push_back(decide(EffectKind::friction,
                           p.effects.friction,
                           friction,
                           "friction coefficient " + to_text(friction)));
  effects.push_back(decide(EffectKind::contact_damping,
                           p.effects.contact_damping,
                           p.contact.damping_ratio,
                           "damping ratio " + to_text(p.contact.damping_ratio)));
  Effect chain_damping = decide(EffectKind::chain_damping,
                                p.effects.chain_damping,
                                p.model.chain_damping_ratio,
                                "chain damping ratio " + to_text(p.model.chain_damping_ratio));
  if (has_clearances)
    chain_damping = {
        EffectKind::chain_damping, false, "there are no bars: the joints' contact damping acts"};
  effects.push_back(chain_damping);
  effects.push_back(decide(EffectKind::gravity,
                           p.effects.gravity,
                           p.loads.gravity,
                           "acceleration " + to_text(p.loads.gravity) + " m/s2"));
  effects.push_back(decide(EffectKind::drag,
                           p.effects.drag,
                           p.loads.drag,
                           "coefficient " + to_text(p.loads.drag) + " 1/s"));
  add(EffectKind::elastic_links, parameters::elastic_links(p));
  add(EffectKind::elastic_rollers, parameters::elastic_rollers(p));
  for (const parameters::Sprocket &sprocket : p.drive.sprockets.list)
    {
      add(EffectKind::elastic_sprocket, parameters::elastic_sprocket(p, sprocket));
      effects.back().sprocket = sprocket.name;
    }
  add(EffectKind::tooth_compliance, parameters::tooth_compliance(p));
  add(EffectKind::plate_bending, parameters::plate_bending(p));
  add(EffectKind::reduced_bodies, parameters::reduced_bodies(p));
  add(EffectKind::column_mass_scaling, parameters::column_mass_scaling(p));
  add(EffectKind::plate_faces, parameters::plate_faces(p));
  add(EffectKind::half_model, parameters::half_model(p));
  add(EffectKind::fields, parameters::fields(p));
  add(EffectKind::stress_recovery, parameters::stress_recovery(p));
  return effects;
}

bool is_on(const std::vector<Effect> &effects, const EffectKind kind, const std::string &sprocket)
{
  for (const Effect &effect : effects)
    if (effect.kind == kind && effect.sprocket == sprocket)
      return effect.on;
  throw std::logic_error("an effect that nobody decided");
}

std::string Effect::name() const
{
  const std::string text =
      std::find_if(std::begin(texts), std::end(texts), [this](const EffectText &entry) {
        return entry.kind == kind;
      })->text;
  return sprocket.empty() ? text : text + " " + sprocket;
}
} // namespace chaindrive::scene
