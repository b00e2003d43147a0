// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/catalogue.h>
#include <chaindrive/drive/design_life.h>
#include <chaindrive/model/arriving_joints.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/model/model.h>

namespace chaindrive::model
{
namespace
{
/// What is observed, and what is not since nobody asks for it.
std::string note_of_quantities(const parameters::Output &output)
{
  std::string asked, left_out;
  for (const auto &[group, name] : parameters::texts_of<parameters::QuantityGroup>)
    {
      std::string &list = output.asks_for(group) ? asked : left_out;
      list += (list.empty() ? "" : ", ") + std::string(name);
    }
  return left_out.empty() ? "Output/Quantities = all: whatever the fidelity has is observed" :
                            "Observed: " + asked + "; not asked for and not computed: " + left_out;
}

Value value_of(const std::optional<double> &given, const double found)
{
  return {given.value_or(found), given.has_value()};
}

Contact contact_of(const parameters::Contact &contact, const Effects &effects)
{
  Contact result;
  if (effects.is_on(Effect::contact_damping))
    result.damping_ratio = contact.damping_ratio;
  if (effects.is_on(Effect::friction))
    {
      const double common          = contact.friction_coefficient;
      result.roller_tooth_friction = contact.roller_tooth_friction.value_or(common);
      result.roller_bush_friction  = contact.roller_bush_friction.value_or(common);
      result.bush_pin_friction     = contact.bush_pin_friction.value_or(common);
      result.plate_friction        = common;
    }
  if (effects.is_on(Effect::oil_film))
    result.oil_viscosity = contact.oil_viscosity;
  result.tangential_ratio  = contact.tangential_ratio;
  result.penalty_factor    = contact.penalty_factor;
  result.search_every_step = contact.search == parameters::Search::every_step;
  return result;
}

parameters::Loads loads_of(const parameters::Loads &given, const Effects &effects)
{
  parameters::Loads loads = given;
  if (!effects.is_on(Effect::gravity))
    loads.gravity = 0.;
  if (!effects.is_on(Effect::drag))
    loads.drag = 0.;
  return loads;
}

Window window_of(const parameters::Output &output)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {!output.window_start,
          output.window_start.value_or(infinity),
          output.window_end.value_or(infinity),
          output.window_pitches};
}

/// Whether rigid sprockets deflect by a stiffness that is auto.
bool teeth_are_compliant(const Parameters &p, const Effects &effects)
{
  return effects.is_on(Effect::tooth_compliance) && !p.contact.tooth_stiffness;
}
} // namespace

Meshes meshes_of(const Parameters &parameters, const Effects &effects)
{
  return {parameters.mesh,
          parameters.material.density,
          effects.is_on(Effect::symmetry_model),
          effects.is_on(Effect::exact_joints)};
}

std::optional<PartStiffnesses> part_stiffnesses(const Parameters &p, const Effects &effects)
{
  const auto [has_clearances, is_elastic, is_reduced] = p.model.capabilities();
  // rigid bodies deflect by them, and a start whose prestress is found with them
  const bool needed = !is_elastic || !effects.is_on(Effect::elastic_links) ||
                      !effects.is_on(Effect::elastic_rollers) ||
                      p.model.elastic_links == parameters::ElasticLinks::region_of_interest ||
                      teeth_are_compliant(p, effects) || !effects.is_on(Effect::start_up);
  if (p.model.stiffness_from == parameters::StiffnessFrom::dimensions || !needed)
    return {};
  return PartStiffnesses{!p.model.stiffness_per_pitch,
                         !p.contact.roller_tooth_stiffness ||
                             (!p.contact.roller_bush_stiffness && has_clearances),
                         teeth_are_compliant(p, effects),
                         effects.is_on(Effect::stiffness_curves),
                         effects.is_on(Effect::tooth_places)};
}

Model make_model(const Parameters &p, const drive::Drive &drive, const Effects &effects)
{
  if (effects.is_on(Effect::tooth_compliance))
    drive::refuse_soft_teeth(p, drive);

  Model model;
  model.effects  = effects;
  model.fidelity = p.model.fidelity;
  model.notes.push_back(note_of_quantities(p.output));

  model.reduced        = p.model.capabilities().is_reduced;
  model.others_reduced = p.model.other_links == parameters::OtherLinks::reduced;
  model.elastic_joints = elastic_joints(p, drive, effects, model.notes);
  model.mass_per_pitch = value_of(p.model.mass_per_pitch, drive.mass_per_pitch);
  model.sections       = p.sections;
  model.material       = p.material;
  model.elements       = p.elements;
  model.meshes         = meshes_of(p, effects);
  model.tooth_facets   = p.drive.sprockets.facets;

  model.contact = contact_of(p.contact, effects);
  model.roller_tooth_stiffness =
      value_of(p.contact.roller_tooth_stiffness, drive.roller_tooth_stiffness);
  model.roller_bush_stiffness =
      value_of(p.contact.roller_bush_stiffness, drive.roller_bush_stiffness);
  model.side_stiffness =
      value_of(p.contact.side_stiffness,
               drive::plate_side_stiffness(drive::inner_plate(drive.chain), p.material));
  for (const drive::Sprocket &sprocket : drive.sprockets)
    model.tooth_stiffness.push_back(value_of(p.contact.tooth_stiffness, sprocket.tooth_stiffness));
  model.stiffness_per_pitch = drive.stiffness_per_pitch;
  if (effects.is_on(Effect::chain_damping))
    model.chain_damping_ratio = p.model.chain_damping_ratio;
  model.loads = loads_of(p.loads, effects);
  if (const drive::CatalogueChain *row = drive::find_chain(p.drive.chain.designation))
    model.tensile_strength = row->strength_of(drive.strands) / drive.strands;
  model.plates = drive::plate_fatigue(drive.chain, drive.holes);

  model.time   = p.time;
  model.output = p.output;
  model.window = window_of(p.output);
  if (effects.is_on(Effect::fields))
    model.field_interval = field_interval(p);
  model.output.field_interval = model.field_interval;
  return model;
}

Model make_model(const Parameters &parameters, const drive::Drive &drive)
{
  return make_model(parameters, drive, decide_effects(parameters));
}
} // namespace chaindrive::model
