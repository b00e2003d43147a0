// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/needs.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

namespace chaindrive::parameters
{
namespace
{
/// The groups that @p p asks for and that need @p what: those named, or `all`; empty if none does.
std::string who_needs(const Parameters &p, bool Needs::*what)
{
  if (p.output.quantities.empty())
    return "all";
  std::string names;
  for (const Needs &needs : all_needs)
    if (needs.*what && p.output.names(needs.group))
      names += (names.empty() ? "" : ", ") + text_of(needs.group);
  return names;
}

/// What an elastic fidelity has if something that is asked for needs it.
Decision decide(const Parameters &p, const Switch choice, bool Needs::*what)
{
  if (!p.model.capabilities().is_elastic)
    return {false, "no group of bodies is elastic in this fidelity"};
  if (choice != Switch::automatic)
    return {choice == Switch::on, "switched " + text_of(choice) + " in section Effects"};
  const std::string who = who_needs(p, what);
  return {!who.empty(),
          who.empty() ? "nothing in Output/Quantities needs it" : "for Output/Quantities = " + who};
}

bool arrive(const Parameters &p)
{
  return p.model.capabilities().is_elastic && p.model.elastic_links == ElasticLinks::arriving;
}

Switch choice_for(const Parameters &p, const Sprocket &sprocket)
{
  return sprocket.elastic != Switch::automatic ? sprocket.elastic : p.model.elastic_sprockets;
}
} // namespace

Decision elastic_links(const Parameters &p)
{
  Decision links = decide(p, p.effects.elastic_links, &Needs::links);
  if (links.on && arrive(p))
    links.reason = "those that arrive in the window: Model/Elastic links";
  return links;
}

Decision elastic_rollers(const Parameters &p)
{
  Decision rollers = decide(p, p.effects.elastic_rollers, &Needs::rollers);
  if (rollers.on && arrive(p))
    rollers.reason = "those that arrive in the window: Model/Elastic links";
  if (!rollers.on && p.effects.elastic_rollers == Switch::automatic)
    for (const Sprocket &sprocket : p.drive.sprockets.list)
      if (choice_for(p, sprocket) == Switch::on && p.model.capabilities().is_elastic)
        return {true, "an elastic sprocket needs them"};
  return rollers;
}

Decision elastic_sprocket(const Parameters &p, const Sprocket &sprocket)
{
  Decision rim = decide(p, choice_for(p, sprocket), &Needs::sprockets);
  if (rim.on && arrive(p))
    return {false, "rigid next to rigid links: Elastic links = arriving"};
  if (rim.on && p.model.capabilities().is_reduced)
    return {false, "rigid next to reduced rollers"};
  if (rim.on && !elastic_rollers(p).on)
    return {false, "a rigid roller meets rigid teeth, whose compliance is not its own"};
  if (sprocket.elastic == Switch::automatic && p.model.elastic_sprockets != Switch::automatic &&
      p.model.capabilities().is_elastic)
    rim.reason = "switched " + text_of(p.model.elastic_sprockets) + " in section Model";
  return rim;
}

Decision tooth_compliance(const Parameters &p)
{
  const Switch choice = p.effects.tooth_compliance;
  if (!p.model.capabilities().is_elastic)
    return {false, "no group of bodies is elastic in this fidelity"};
  if (!elastic_rollers(p).on)
    return {false, "rollers are rigid: their contact with rigid teeth has one stiffness"};
  const auto &sprockets = p.drive.sprockets.list;
  if (std::all_of(sprockets.begin(), sprockets.end(), [&p](const Sprocket &sprocket) {
        return elastic_sprocket(p, sprocket).on;
      }))
    return {false, "sprockets are elastic"};
  if (choice != Switch::automatic)
    return {choice == Switch::on, "switched " + text_of(choice) + " in section Effects"};
  const bool reduced = p.model.capabilities().is_reduced;
  return {reduced,
          reduced ? "reduced rollers press rigid sprockets" : "teeth of rigid sprockets are rigid"};
}

Decision half_model(const Parameters &p)
{
  if (!p.model.capabilities().is_elastic)
    return {false, "no group of bodies is elastic in this fidelity"};
  if (p.model.half == HalfModel::yes)
    return {true, "asked for: the middle plane is a plane of symmetry"};
  if (p.model.half == HalfModel::no)
    return {false, "asked for: whole bodies"};
  if (!elastic_links(p).on || !elastic_rollers(p).on)
    return {false, "whole bodies: rigid ones are"};
  if (plate_faces(p).on)
    return {false, "whole bodies: plates touch where something pushes them sideways"};
  for (const Sprocket &sprocket : p.drive.sprockets.list)
    if (!sprocket.mesh.empty())
      return {false, "whole bodies: an imported mesh may lack symmetry"};
  // pictures show both halves: without any, nobody needs them
  const std::string who = fields(p).on ? who_needs(p, &Needs::both_halves) : "";
  if (!who.empty())
    return {false, "whole bodies: for Output/Quantities = " + who};
  return {true, "the middle plane is a plane of symmetry, and nothing asked for needs both halves"};
}

Decision plate_bending(const Parameters &p)
{
  if (!elastic_links(p).on)
    return {false, "links are not elastic"};
  if (p.effects.plate_bending == Switch::off)
    return {false, "switched off in section Effects: middle surfaces stay in their planes"};
  return {true, "out of their planes; in them it comes with elastic links"};
}

Decision plate_faces(const Parameters &p)
{
  if (!elastic_links(p).on)
    return {false, "links are not elastic"};
  if (p.contact.plate_faces == Switch::on)
    return {true, "asked for in section Contact: between elastic links"};
  return {false,
          p.contact.plate_faces == Switch::off ?
              "Contact/Plate faces: plates pass through each other" :
              "nothing pushes the chain sideways"};
}

Decision reduced_bodies(const Parameters &p)
{
  if (!elastic_links(p).on && !elastic_rollers(p).on)
    return {false, "neither links nor rollers are elastic"};
  if (p.model.capabilities().is_reduced)
    return {true, "fidelity " + text_of(p.model.fidelity)};
  if (!arrive(p))
    return {false, "elastic bodies move by their nodes"};
  const bool others = p.model.other_links == OtherLinks::reduced;
  return {others, "Model/Other links = " + text_of(p.model.other_links)};
}

Decision column_mass_scaling(const Parameters &p)
{
  if (!elastic_rollers(p).on)
    return {false, "rollers are not elastic"};
  if (p.model.capabilities().is_reduced)
    return {false, "rollers move by modes"};
  const double factor = p.elements.column_mass_scaling;
  return {factor > 0., "Elements/Column mass scaling = " + to_entry_text(factor, unit::si)};
}

double field_interval(const Parameters &p)
{
  const double frequency = p.drive.sprockets.driver().teeth * p.loads.driver_speed;
  return p.output.field_interval.value_or(
      frequency > 0. ? 0.1 * 2. * dealii::numbers::PI / frequency : 1e-3);
}

Decision fields(const Parameters &p)
{
  if (!p.output.asks_for(QuantityGroup::fields))
    return {false, "Output/Quantities do not name them"};
  const double interval = field_interval(p);
  return {interval > 0., "field interval " + to_entry_text(interval, unit::milli) + " ms"};
}

Decision stress_recovery(const Parameters &p)
{
  const bool plates = elastic_links(p).on && p.output.asks_for(QuantityGroup::plate_stress);
  const bool bodies = (elastic_links(p).on || elastic_rollers(p).on) && fields(p).on;
  if (!plates && !bodies)
    return {false,
            p.model.capabilities().is_elastic ?
                "neither plate stress nor fields of elastic bodies are requested" :
                "no body is elastic"};
  return {true,
          std::string(plates ? "at the waists of plates" : "") + (plates && bodies ? ", " : "") +
              (bodies ? "in field output" : "")};
}

Decision clearance(const Parameters &p, const Switch choice)
{
  if (!p.model.capabilities().has_clearances)
    return {false, "fidelity " + text_of(p.model.fidelity) + ": roller, bush and pin are one lump"};
  if (choice == Switch::off)
    return {false, "switched off in section Effects: the bore fits"};
  return {true,
          "fidelity " + text_of(p.model.fidelity) + ": roller, bush and pin are separate bodies"};
}

std::string documentation_of_needs()
{
  std::string text =
      "\n## What needs what\n\nIn full fidelity these effects are on where they are `auto` and one "
      "of `Output/Quantities`\nneeds them. All others are on wherever they can act: they cost "
      "next to nothing, and all\nresults depend on them.\n\n"
      "| Quantities | Elastic links | Elastic rollers | Elastic driver, driven | Both halves | "
      "Reason |\n|---|---|---|---|---|---|\n";
  const auto cell = [](const bool needed) { return std::string(needed ? "needed" : "-") + " | "; };
  for (const Needs &needs : all_needs)
    text += "| `" + text_of(needs.group) + "` | " + cell(needs.links) + cell(needs.rollers) +
            cell(needs.sprockets) + cell(needs.both_halves) + needs.reason + " |\n";
  return text;
}
} // namespace chaindrive::parameters
