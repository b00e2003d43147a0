// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/model/needs.h>
#include <chaindrive/model/tooth_places.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <optional>

namespace chaindrive::model
{
using parameters::QuantityGroup;
using parameters::Switch;

namespace
{
constexpr const char *nothing_elastic = "no group of bodies is elastic in this fidelity";

constexpr const char *no_rollers = "the chain has no rollers: bushes of links meet the teeth";

bool has_rollers(const Parameters &p) { return drive::has_rollers(p.drive.chain); }

bool is_elastic(const Parameters &p) { return p.model.capabilities().is_elastic; }

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

std::string switched(const Switch choice, const char *section)
{
  return "switched " + text_of(choice) + " in section " + section;
}

/// What has a coefficient, which is called @p coefficient_text.
Decision decide(const Effect       effect,
                const Switch       choice,
                const double       coefficient,
                const std::string &coefficient_text)
{
  if (choice == Switch::off)
    return {effect, false, switched(choice, "Effects")};
  const bool on = acts(choice, coefficient);
  return {effect, on, coefficient_text + (on ? "" : " is zero")};
}

/// What an elastic fidelity has if something that is asked for needs it.
Decision decide(const Effect effect, const Parameters &p, const Switch choice, bool Needs::*what)
{
  if (!is_elastic(p))
    return {effect, false, nothing_elastic};
  if (choice != Switch::automatic)
    return {effect, choice == Switch::on, switched(choice, "Effects")};
  const std::string who = who_needs(p, what);
  return {effect,
          !who.empty(),
          who.empty() ? "nothing in Output/Quantities needs it" : "for Output/Quantities = " + who};
}

bool has_region_of_interest(const Parameters &p)
{
  return is_elastic(p) && p.model.elastic_links == parameters::ElasticLinks::region_of_interest;
}

/// What holds of links and rollers alike.
Decision where_they_arrive(const Parameters &p, Decision decision)
{
  if (decision.on && has_region_of_interest(p))
    decision.reason = "those in the region of interest: Model/Elastic links";
  return decision;
}

Decision elastic_links(const Parameters &p)
{
  Decision links = where_they_arrive(
      p, decide(Effect::elastic_links, p, p.effects.elastic_links, &Needs::links));
  if (!links.on && is_elastic(p) && !has_rollers(p) &&
      p.effects.elastic_links == Switch::automatic &&
      decide(Effect::elastic_links, p, Switch::automatic, &Needs::rollers).on)
    return {Effect::elastic_links, true, "their bushes are in the place of rollers"};
  return links;
}

Switch choice_for(const Parameters &p, const parameters::Sprocket &sprocket)
{
  return sprocket.elastic != Switch::automatic ? sprocket.elastic : p.model.elastic_sprockets;
}

/// Of a chain without rollers those are its bushes.
Decision elastic_rollers(const Parameters &p, const Decision &links)
{
  if (!has_rollers(p))
    return {Effect::elastic_rollers, links.on, is_elastic(p) ? no_rollers : nothing_elastic};
  Decision rollers = where_they_arrive(
      p, decide(Effect::elastic_rollers, p, p.effects.elastic_rollers, &Needs::rollers));
  if (!rollers.on && is_elastic(p) && p.effects.elastic_rollers == Switch::automatic)
    for (const parameters::Sprocket &sprocket : p.drive.sprockets.list)
      if (choice_for(p, sprocket) == Switch::on)
        return {Effect::elastic_rollers, true, "an elastic sprocket needs them"};
  return rollers;
}

Decision
elastic_sprocket(const Parameters &p, const parameters::Sprocket &sprocket, const bool rollers)
{
  constexpr Effect effect = Effect::elastic_sprocket;
  Decision         rim    = decide(effect, p, choice_for(p, sprocket), &Needs::sprockets);
  rim.sprocket            = sprocket.name;
  if (rim.on && has_region_of_interest(p))
    return {effect,
            false,
            "rigid next to rigid links: Elastic links = region of interest",
            sprocket.name};
  if (rim.on && p.model.capabilities().is_reduced)
    return {effect, false, "rigid next to reduced rollers", sprocket.name};
  if (rim.on && sprocket.is_flat())
    return {effect, false, "a drum is rigid", sprocket.name};
  if (rim.on && is_sprung(sprocket.held.holder))
    return {effect, false, "rigid on its tensioner, whose mass it is a part of", sprocket.name};
  if (rim.on && sprocket.swing.is_active())
    return {effect, false, "rigid on its arm, which moves as is prescribed", sprocket.name};
  if (rim.on && sprocket.bearing.stiffness)
    return {effect, false, "rigid on its bearing, with whose slides it moves", sprocket.name};
  if (rim.on && !rollers)
    return {effect,
            false,
            "a rigid roller meets rigid teeth, whose compliance is not its own",
            sprocket.name};
  if (sprocket.elastic == Switch::automatic && p.model.elastic_sprockets != Switch::automatic &&
      is_elastic(p))
    rim.reason = switched(p.model.elastic_sprockets, "Model");
  return rim;
}

Decision
tooth_compliance(const Parameters &p, const bool rollers, const std::vector<Decision> &rims)
{
  constexpr Effect effect = Effect::tooth_compliance;
  const Switch     choice = p.effects.tooth_compliance;
  if (!is_elastic(p))
    return {effect, false, nothing_elastic};
  if (!rollers)
    return {effect, false, "rollers are rigid: their contact with rigid teeth has one stiffness"};
  if (std::all_of(rims.begin(), rims.end(), [](const Decision &rim) { return rim.on; }))
    return {effect, false, "sprockets are elastic"};
  if (choice != Switch::automatic)
    return {effect, choice == Switch::on, switched(choice, "Effects")};
  const bool reduced = p.model.capabilities().is_reduced;
  return {effect,
          reduced,
          reduced ? "reduced rollers press rigid sprockets" : "teeth of rigid sprockets are rigid"};
}

Decision plate_bending(const Parameters &p, const bool links)
{
  constexpr Effect effect = Effect::plate_bending;
  if (!links)
    return {effect, false, "links are not elastic"};
  if (p.effects.plate_bending == Switch::off)
    return {effect, false, "switched off in section Effects: middle surfaces stay in their planes"};
  return {effect, true, "out of their planes; in them it comes with elastic links"};
}

/// Whether any wheel is out of line.
Decision misalignment(const Parameters &p)
{
  std::string names;
  for (const parameters::Sprocket &sprocket : p.drive.sprockets.list)
    if (sprocket.is_out_of_line())
      names += (names.empty() ? "" : ", ") + sprocket.name;
  return {Effect::misalignment,
          !names.empty(),
          names.empty() ? "all wheels are in the plane of the drive" : "out of line: " + names};
}

/// Whether strands of a chain of several have bodies of their own.
Decision separate_strands(const Parameters &p)
{
  constexpr Effect   effect                     = Effect::separate_strands;
  const unsigned int strands                    = p.drive.chain.strands;
  const Switch       choice                     = p.effects.separate_strands;
  const auto [has_clearances, elastic, reduced] = p.model.capabilities();
  if (strands == 1)
    return {effect, false, "Drive/Chain/Strands = 1"};
  if (choice == Switch::off)
    return {effect, false, switched(choice, "Effects")};
  if (!has_clearances || elastic)
    return {effect, false, "fidelity " + p.model.fidelity + ": one strand stands for all"};
  if (choice == Switch::on)
    return {effect, true, switched(choice, "Effects")};
  const Decision out_of_line = misalignment(p);
  return {effect,
          out_of_line.on,
          out_of_line.on ? "wheels are out of line and pull strands unevenly" :
                           "wheels are in line: strands share equally, and one stands for all"};
}

Decision plate_faces(const Parameters &p, const bool links)
{
  constexpr Effect effect = Effect::plate_faces;
  if (!links)
    return {effect, false, "links are not elastic"};
  if (p.contact.plate_faces == Switch::on)
    return {effect, true, "asked for in section Contact: between elastic links"};
  if (p.contact.plate_faces == Switch::automatic && misalignment(p).on)
    return {effect, true, "wheels are out of line"};
  return {effect,
          false,
          p.contact.plate_faces == Switch::off ?
              "Contact/Plate faces: plates pass through each other" :
              "nothing pushes the chain sideways"};
}

Decision reduced_bodies(const Parameters &p, const bool links, const bool rollers)
{
  constexpr Effect effect = Effect::reduced_bodies;
  if (!links && !rollers)
    return {effect, false, "neither links nor rollers are elastic"};
  if (p.model.capabilities().is_reduced)
    return {effect, true, "fidelity " + p.model.fidelity};
  if (!has_region_of_interest(p))
    return {effect, false, "elastic bodies move by their nodes"};
  const bool others = p.model.other_links == parameters::OtherLinks::reduced;
  return {effect, others, "Model/Other links = " + text_of(p.model.other_links)};
}

Decision exact_joints(const Parameters &p, const bool links, const bool rollers)
{
  constexpr Effect              effect      = Effect::exact_joints;
  const parameters::Enforcement enforcement = p.contact.enforcement;
  if (!p.model.capabilities().is_reduced)
    return {effect, false, "fidelity " + p.model.fidelity + " has bodies that are not reduced"};
  if (!has_rollers(p))
    return {effect, false, no_rollers};
  if (enforcement != parameters::Enforcement::automatic)
    return {effect,
            enforcement != parameters::Enforcement::penalty,
            "Contact/Enforcement = " + text_of(enforcement)};
  if (has_region_of_interest(p))
    return {effect, false, "links outside the region of interest are not reduced"};
  if (!links || !rollers)
    return {effect, false, "links or rollers are rigid"};
  if (p.reduction.modes_up_to && *p.reduction.modes_up_to < least_modes_of_exact_joints)
    return {effect,
            false,
            "Reduction/Modes up to in kHz = " +
                parameters::to_entry_text(*p.reduction.modes_up_to, parameters::unit::kilo) +
                " is below " +
                parameters::to_entry_text(least_modes_of_exact_joints, parameters::unit::kilo)};
  return {effect, true, "links and rollers are reduced"};
}

Decision exact_teeth(const Parameters &p, const Decision &joints, const bool faces)
{
  constexpr Effect              effect      = Effect::exact_teeth;
  const parameters::Enforcement enforcement = p.contact.enforcement;
  if (!joints.on || enforcement != parameters::Enforcement::automatic)
    return {effect, joints.on && enforcement == parameters::Enforcement::exact, joints.reason};
  if (p.effects.contact_damping == Switch::on && !anything_overlaps(p, true, faces))
    return {effect, false, "Effects/Contact damping = on damps what overlaps"};
  for (const parameters::Sprocket &sprocket : p.drive.sprockets.list)
    if (!sprocket.mesh.empty())
      return {effect, false, "the " + sprocket.in_words() + " has the flanks of its mesh"};
  return {effect, true, "rollers are reduced, teeth are rigid arcs"};
}

Decision selective_mass_scaling(const Parameters &p, const bool rollers)
{
  constexpr Effect effect = Effect::selective_mass_scaling;
  if (!has_rollers(p))
    return {effect, false, no_rollers};
  if (!rollers)
    return {effect, false, "rollers are not elastic"};
  if (p.model.capabilities().is_reduced)
    return {effect, false, "rollers move by modes"};
  const double factor = p.elements.selective_mass_scaling;
  return {effect,
          factor > 0.,
          "Elements/Selective mass scaling = " +
              parameters::to_entry_text(factor, parameters::unit::si)};
}

Decision fields(const Parameters &p)
{
  if (!p.output.asks_for(QuantityGroup::fields))
    return {Effect::fields, false, "Output/Quantities do not name them"};
  const double interval = field_interval(p);
  return {Effect::fields,
          interval > 0.,
          "field interval " + parameters::to_entry_text(interval, parameters::unit::milli) + " ms"};
}

Decision symmetry_model(const Parameters &p,
                        const bool        links,
                        const bool        rollers,
                        const bool        plate_faces,
                        const bool        pictures)
{
  constexpr Effect effect = Effect::symmetry_model;
  if (!is_elastic(p))
    return {effect, false, nothing_elastic};
  if (p.model.half == parameters::SymmetryModel::yes)
    return {effect, true, "asked for: the middle plane is a plane of symmetry"};
  if (p.model.half == parameters::SymmetryModel::no)
    return {effect, false, "asked for: whole bodies"};
  if (!links || !rollers)
    return {effect, false, "whole bodies: rigid ones are"};
  if (misalignment(p).on)
    return {effect, false, "whole bodies: wheels are out of line"};
  if (plate_faces)
    return {effect, false, "whole bodies: plates touch where something pushes them sideways"};
  for (const parameters::Sprocket &sprocket : p.drive.sprockets.list)
    if (!sprocket.mesh.empty())
      return {effect, false, "whole bodies: an imported mesh may lack symmetry"};
  // field output shows both halves: without any, nobody needs them
  const std::string who = pictures ? who_needs(p, &Needs::both_halves) : "";
  if (!who.empty())
    return {effect, false, "whole bodies: for Output/Quantities = " + who};
  return {effect,
          true,
          "the middle plane is a plane of symmetry, and nothing asked for needs both halves"};
}

/// Why bodies may leave the plane of the chain; empty if nothing can take them out of it.
std::string what_leaves_plane(const Parameters &p)
{
  if (misalignment(p).on)
    return "wheels are out of line";
  if (separate_strands(p).on)
    return "strands are separate";
  for (const parameters::Sprocket &sprocket : p.drive.sprockets.list)
    if (!sprocket.mesh.empty())
      return "an imported mesh may lack symmetry";
  for (const std::string &path : p.sections.active("Additions"))
    return path + " may push across the chain";
  return "";
}

Decision planar_motion(const Parameters &p)
{
  constexpr Effect effect = Effect::planar_motion;
  if (is_elastic(p))
    return {effect, false, "elastic bodies move in space"};
  if (p.effects.planar_motion == Switch::off)
    return {effect, false, switched(Switch::off, "Effects")};
  const std::string what = what_leaves_plane(p);
  return {effect, what.empty(), what.empty() ? "nothing leaves the plane of the chain" : what};
}

Decision oval_rollers(const Parameters &p, const Decision &planar)
{
  constexpr Effect effect = Effect::oval_rollers;
  const auto       off    = [](const std::string &why) { return Decision{effect, false, why}; };
  if (is_elastic(p))
    return off("elastic rollers deform, rigid ones beside them stay round");
  if (!p.model.capabilities().has_clearances)
    return off("fidelity " + p.model.fidelity + ": a roller is one lump with its links");
  if (!has_rollers(p))
    return off(no_rollers);
  if (p.effects.roller_bush_clearance == Switch::off)
    return off("a bush that fits its roller keeps it round");
  if (p.effects.oval_rollers != Switch::on)
    return off(p.effects.oval_rollers == Switch::off ? switched(Switch::off, "Effects") :
                                                       "auto: rigid rollers stay round");
  // the contact of an oval of about the size of the clearance has two places, not one
  const drive::ChainDimensions chain = drive::make_chain(p.drive.chain);
  if (chain.roller_clearance() < 0.0005 * chain.roller_diameter)
    return off("bushes have a radial clearance of " + to_text(1e6 * chain.roller_clearance(), 3) +
               " um in rollers, less than " + to_text(500. * chain.roller_diameter, 3) +
               " um, a thousandth of their radius, and keep them round");
  return {effect,
          planar.on,
          planar.on ? switched(Switch::on, "Effects") : "not planar: " + planar.reason};
}

Decision stiffness_curves(const Parameters &p, const Decision &planar)
{
  constexpr Effect effect = Effect::stiffness_curves;
  const auto       off    = [](const std::string &why) { return Decision{effect, false, why}; };
  if (is_elastic(p))
    return off("elastic bodies deflect themselves");
  if (!p.model.capabilities().has_clearances)
    return off("fidelity " + p.model.fidelity + ": a roller is one lump with its links");
  if (!has_rollers(p))
    return off(no_rollers);
  if (p.effects.stiffness_curves == Switch::off)
    return off(switched(Switch::off, "Effects"));
  if (p.model.stiffness_from == parameters::StiffnessFrom::dimensions)
    return off("Model/Stiffness from = dimensions knows no curves");
  if (p.model.stiffness_per_pitch && p.contact.roller_tooth_stiffness &&
      p.contact.roller_bush_stiffness)
    return off("all stiffnesses are given");
  if (p.contact.oil_viscosity > 0. && p.effects.oil_film != Switch::off)
    return off("oil films stand on contacts of one stiffness");
  if (!planar.on)
    return off("not planar: " + planar.reason);
  if (p.effects.stiffness_curves == Switch::on)
    return {effect, true, switched(Switch::on, "Effects")};
  return {effect, true, "parts get stiffer under load, and teeth are softer higher up"};
}

Decision yielding_shafts(const Parameters &p)
{
  std::string which;
  const auto  add = [&which](const std::string &more) {
    which += (which.empty() ? "" : ", ") + more;
  };
  for (const parameters::Sprocket &wheel : p.drive.sprockets.list)
    {
      if (wheel.coupling.stiffness)
        add("the coupling of the " + wheel.in_words());
      if (wheel.bearing.stiffness)
        add("the bearing of the " + wheel.in_words());
    }
  return {Effect::yielding_shafts,
          !which.empty(),
          which.empty() ? "Drive/Wheels: all bearings and couplings are rigid" :
                          which + " in Drive/Wheels"};
}

Decision
stress_recovery(const Parameters &p, const bool links, const bool rollers, const bool pictures)
{
  constexpr Effect effect = Effect::stress_recovery;
  const bool       plates = links && p.output.asks_for(QuantityGroup::plate_stress);
  const bool       bodies = (links || rollers) && pictures;
  if (!plates && !bodies)
    return {effect,
            false,
            is_elastic(p) ? "neither plate stress nor fields of elastic bodies are requested" :
                            "no body is elastic"};
  return {effect,
          true,
          std::string(plates ? "at the waists of plates" : "") + (plates && bodies ? ", " : "") +
              (bodies ? "in field output" : "")};
}

/// Whether the cylinders of a joint have clearance.
Decision clearance(const Effect effect, const Parameters &p, const Switch choice)
{
  const std::string fidelity = "fidelity " + p.model.fidelity;
  if (!p.model.capabilities().has_clearances)
    return {effect, false, fidelity + ": roller, bush and pin are one lump"};
  if (effect == Effect::roller_bush_clearance && !has_rollers(p))
    return {effect, false, no_rollers};
  if (choice == Switch::off)
    return {effect, false, "switched off in section Effects: the bore fits"};
  return {effect, true, fidelity + ": roller, bush and pin are separate bodies"};
}

Decision chain_bars(const Parameters &p)
{
  const auto [has_clearances, elastic, reduced] = p.model.capabilities();
  return {Effect::chain_bars,
          !has_clearances,
          "fidelity " + p.model.fidelity + ": " +
              (reduced        ? "links deform by modes" :
               elastic        ? "links are made of finite elements" :
               has_clearances ? "links are rigid, their compliance sits in the joints" :
                                "plates are elastic bars")};
}

/// The largest friction coefficient of the interfaces that the fidelity of @p p has.
double largest_friction(const Parameters &p, const bool plate_faces)
{
  const parameters::Contact &contact = p.contact;
  const auto                 of      = [&contact](const std::optional<double> &own) {
    return own.value_or(contact.friction_coefficient);
  };
  double largest = of(contact.roller_tooth_friction);
  if (p.model.capabilities().has_clearances)
    largest = std::max({largest,
                        has_rollers(p) ? of(contact.roller_bush_friction) : 0.,
                        of(contact.bush_pin_friction)});
  if (plate_faces)
    largest = std::max(largest, contact.friction_coefficient);
  return largest;
}

Decision chain_damping(const Parameters &p)
{
  const double ratio = p.model.chain_damping_ratio;
  if (p.model.capabilities().has_clearances)
    return {Effect::chain_damping, false, "there are no bars; joints have contact damping or none"};
  return decide(Effect::chain_damping,
                p.effects.chain_damping,
                ratio,
                "chain damping ratio " + to_text(ratio));
}

Decision contact_damping(const Parameters &p, const bool exact, const bool faces)
{
  if (!anything_overlaps(p, exact, faces))
    return {Effect::contact_damping, false, "nothing overlaps that could be damped"};
  return decide(Effect::contact_damping,
                p.effects.contact_damping,
                p.contact.damping_ratio,
                "damping ratio " + to_text(p.contact.damping_ratio));
}

Decision start_up(const Parameters &p)
{
  const parameters::Start start   = p.drive.layout.start;
  const bool              settled = start == parameters::Start::settled;
  return {Effect::start_up,
          !settled,
          "Drive/Layout/Start = " + text_of(start) + (settled ? ": at full speed" : ": from rest")};
}
} // namespace

bool anything_overlaps(const Parameters &p, const bool exact_teeth, const bool plate_faces)
{
  const auto &wheels = p.drive.sprockets.list;
  return !exact_teeth || plate_faces ||
         std::any_of(wheels.begin(), wheels.end(), [](const parameters::Sprocket &wheel) {
           return !wheel.guide.points.empty();
         });
}

double field_interval(const Parameters &p)
{
  const double frequency = p.drive.sprockets.driver().teeth * p.loads.driver_speed;
  return p.output.field_interval.value_or(
      frequency > 0. ? 0.1 * 2. * dealii::numbers::PI / frequency : 1e-3);
}

Effects decide_effects(const Parameters &p)
{
  // what others depend on comes first
  const Decision        links   = elastic_links(p);
  const Decision        rollers = elastic_rollers(p, links);
  std::vector<Decision> rims;
  for (const parameters::Sprocket &sprocket : p.drive.sprockets.list)
    rims.push_back(elastic_sprocket(p, sprocket, rollers.on));
  const Decision faces = plate_faces(p, links.on), pictures = fields(p),
                 joints     = exact_joints(p, links.on, rollers.on),
                 teeth      = exact_teeth(p, joints, faces.on),
                 compliance = tooth_compliance(p, rollers.on, rims),
                 places = tooth_places(p, compliance, teeth), out_of_line = misalignment(p),
                 planar          = planar_motion(p);
  const double          friction = largest_friction(p, faces.on || out_of_line.on);
  std::vector<Decision> all{
      clearance(Effect::roller_bush_clearance, p, p.effects.roller_bush_clearance),
      clearance(Effect::bush_pin_clearance, p, p.effects.bush_pin_clearance),
      chain_bars(p),
      decide(Effect::friction,
             p.effects.friction,
             friction,
             "friction coefficient " + to_text(friction)),
      contact_damping(p, teeth.on, faces.on),
      chain_damping(p),
      decide(Effect::gravity,
             p.effects.gravity,
             p.loads.gravity,
             "acceleration " + to_text(p.loads.gravity) + " m/s2"),
      decide(Effect::drag,
             p.effects.drag,
             p.loads.drag,
             "coefficient " + to_text(p.loads.drag) + " 1/s"),
      decide(Effect::oil_film,
             p.effects.oil_film,
             p.contact.oil_viscosity,
             "viscosity " + to_text(1e3 * p.contact.oil_viscosity) + " mPa s"),
      links,
      rollers};
  all.insert(all.end(), rims.begin(), rims.end());
  all.insert(all.end(),
             {compliance,
              places,
              tooth_inertia(p, places),
              plate_bending(p, links.on),
              reduced_bodies(p, links.on, rollers.on),
              joints,
              teeth,
              selective_mass_scaling(p, rollers.on),
              faces,
              out_of_line,
              separate_strands(p),
              symmetry_model(p, links.on, rollers.on, faces.on, pictures.on),
              planar,
              oval_rollers(p, planar),
              stiffness_curves(p, planar),
              yielding_shafts(p),
              pictures,
              stress_recovery(p, links.on, rollers.on, pictures.on),
              start_up(p)});
  return Effects(all);
}
} // namespace chaindrive::model
