// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/model/cross_checks.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/model/needs.h>
#include <chaindrive/model/needs_rollers.h>
#include <chaindrive/model/out_of_line.h>
#include <chaindrive/model/refused_switches.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace chaindrive::model
{
using parameters::CentreDistanceFrom;
using parameters::ElasticLinks;
using parameters::OtherLinks;
using parameters::PitchSet;
using parameters::QuantityGroup;
using parameters::SeatCentre;
using parameters::Sprocket;
using parameters::Sprockets;
using parameters::Start;
using parameters::Switch;
using parameters::SymmetryModel;
using parameters::to_entry_text;
using parameters::WornChain;
namespace unit = parameters::unit;

namespace
{
/// Sentences found so far: contradictions stop the run, notes do not.
struct Findings
{
  std::vector<std::string> contradictions, notes;

  void contradiction(const bool found, const std::string &sentence)
  {
    if (found)
      contradictions.push_back(sentence);
  }
  void note(const bool found, const std::string &sentence)
  {
    if (found)
      notes.push_back(sentence);
  }
};

std::string ms(const double value) { return to_entry_text(value, unit::milli) + " ms"; }
std::string us(const double value) { return to_entry_text(value, unit::micro) + " us"; }

std::string chosen_fidelity(const Parameters &p) { return "Model/Fidelity = " + p.model.fidelity; }

void check_settled_window(const Parameters &p, Findings &findings)
{
  const std::string settled = "Output/Window start in ms = settled";
  findings.contradiction(p.output.window_end.has_value(),
                         settled + " ends after Output/Window length in pitches; leave Window end "
                                   "in ms auto.");
  findings.contradiction(p.loads.driver_speed == 0.,
                         settled + " counts the pitches that the driver takes in, but Loads/Driver "
                                   "speed in rad/s = 0; give a time.");
  findings.contradiction(p.model.elastic_links == ElasticLinks::region_of_interest,
                         settled +
                             " cannot be with Model/Elastic links = region of interest, which must "
                             "know before the start which links arrive in the window; give a time, "
                             "or choose Elastic links = all.");
}

void check_window(const Parameters &p, Findings &findings)
{
  findings.contradiction(
      !p.output.until.empty() && p.loads.driver_speed == 0.,
      "Output/Until counts the pitches that the driver takes in, but Loads/Driver "
      "speed in rad/s = 0; leave Until empty.");
  const parameters::Output &output = p.output;
  if (!output.window_start)
    return check_settled_window(p, findings);
  const double from = *output.window_start, end = p.time.end;
  findings.contradiction(from >= end,
                         "Output/Window start in ms lies at or after the end of the run, so that "
                         "nothing would be averaged: " +
                             ms(from) + " against " + ms(end) +
                             "; begin the window earlier or run longer.");
  findings.contradiction(
      output.window_end && *output.window_end <= from,
      "Output/Window end in ms must be above Output/Window start in ms; they are " +
          ms(output.window_end.value_or(0.)) + " and " + ms(from) + ".");
  findings.contradiction(output.window_end && *output.window_end > end,
                         "Output/Window end in ms lies after the end of the run: " +
                             ms(output.window_end.value_or(0.)) + " against " + ms(end) +
                             "; end the window earlier, choose auto, or run longer.");
  findings.note(
      from < p.time.start,
      "Output/Window start in ms lies before the start of the run: the averages begin with the "
      "run.");
}

void check_times(const Parameters &p, const Effects &effects, Findings &findings)
{
  const parameters::Time   &time   = p.time;
  const parameters::Output &output = p.output;
  const double              start = time.start, end = time.end, duration = end - start;

  findings.contradiction(end <= start,
                         "The run would end before it starts: Time/End time in ms must be above "
                         "Time/Start time in ms; they are " +
                             ms(end) + " and " + ms(start) + ".");
  if (end <= start)
    return; // everything below would only repeat it

  findings.contradiction(
      time.step && *time.step > duration,
      "Time/Time step in us is longer than the whole run: " + us(time.step.value_or(0.)) +
          " against " + ms(duration) + "; choose a smaller step or auto.");
  findings.contradiction(
      output.history_interval > duration,
      "Output/History interval in us is longer than the whole run: " + us(output.history_interval) +
          " against " + ms(duration) + "; choose a shorter interval.");
  findings.note(effects.is_on(Effect::fields) && field_interval(p) > duration,
                "Output/Field interval in ms is longer than the whole run: only its first state "
                "is written for ParaView.");

  check_window(p, findings);
}

/// What follows an entry and its verb where it needs rigid teeth and @p elastic says that those of
/// @p sprocket are not, with the entry that makes them so.
std::string for_rigid_teeth(const Sprocket &sprocket, const Decision &elastic)
{
  return " for rigid teeth, but those of the " + sprocket.in_words() + " are elastic (" +
         elastic.reason + "); choose " +
         (sprocket.elastic == Switch::on ? "Effects/Elastic " + sprocket.name :
                                           "Model/Elastic sprockets") +
         " = off";
}

void check_facets(const Parameters &p, const Effects &effects, Findings &findings)
{
  const unsigned int facets = p.drive.sprockets.facets;
  if (facets == 0)
    return;
  const std::string entry = "Drive/Sprockets/Facets per tooth = " + std::to_string(facets);
  findings.contradiction(facets < 12 || facets % 2 == 1,
                         entry + " must be an even number from 12 on, or 0 for smooth teeth.");
  for (unsigned int i = 0; i < p.drive.sprockets.list.size(); ++i)
    {
      const Sprocket &sprocket = p.drive.sprockets.list[i];
      const Decision &elastic  = effects.of(Effect::elastic_sprocket, i);
      findings.contradiction(elastic.on,
                             entry + " is" + for_rigid_teeth(sprocket, elastic) + ", or 0.");
      findings.contradiction(!sprocket.mesh.empty(),
                             entry + " is for teeth of arcs, but the " + sprocket.in_words() +
                                 " has the flanks of its mesh; choose 0.");
    }
}

void check_teeth_off_place(const Parameters &p, const Effects &effects, Findings &findings)
{
  for (unsigned int i = 0; i < p.drive.sprockets.list.size(); ++i)
    {
      const Sprocket &sprocket = p.drive.sprockets.list[i];
      const Decision &elastic  = effects.of(Effect::elastic_sprocket, i);
      if (sprocket.index_tolerance == 0. && sprocket.index_deviations.empty())
        continue;
      const std::string entries =
          "Drive/Wheels/" + sprocket.name + "/Index tolerance in um and Index deviations in um";
      findings.contradiction(
          p.drive.layout.start == Start::concentric,
          entries + " cannot be with Drive/Layout/Start = concentric, in which rollers "
                    "stand in the middle of gaps; choose taut or settled.");
      findings.contradiction(elastic.on,
                             entries + " are" + for_rigid_teeth(sprocket, elastic) +
                                 ", or 0 and no list.");
    }
}

void check_chain(const Parameters &p, const Effects &effects, Findings &findings)
{
  const parameters::Drive &drive      = p.drive;
  const Sprockets         &sprockets  = drive.sprockets;
  const bool               alternate  = p.model.capabilities().has_clearances;
  const bool               odd        = drive.n_links % 2 != 0;
  const bool               bottoms    = sprockets.seat_centre == SeatCentre::bottom_diameter;
  const auto               has_bottom = [](const Sprocket &sprocket) {
    return sprocket.bottom_diameter.has_value();
  };

  findings.contradiction(alternate && odd,
                         "Drive/Number of links = " + std::to_string(drive.n_links) +
                             " is odd, but " + chosen_fidelity(p) +
                             " takes inner and outer links by turns, which needs an even number; "
                             "use one link more or less, auto, or for a chain with an offset link "
                             "Model/Fidelity = simple.");
  findings.note(!alternate && odd,
                "Drive/Number of links = " + std::to_string(drive.n_links) +
                    " is odd: a real chain needs an offset link, which the simple model does not "
                    "tell from the others.");

  findings.contradiction(
      bottoms && !std::all_of(sprockets.list.begin(), sprockets.list.end(), has_bottom),
      "Drive/Sprockets/Seat centre = bottom diameter needs both Driver bottom diameter in mm and "
      "Driven bottom diameter in mm; give them, or choose iso or pitch.");
  findings.note(!bottoms && std::any_of(sprockets.list.begin(), sprockets.list.end(), has_bottom),
                "The bottom diameters of Drive/Sprockets have no effect, since Seat centre is " +
                    text_of(sprockets.seat_centre) + ".");
  findings.contradiction(
      drive.chain.pitch_set == PitchSet::paper_literal && !bottoms,
      "Drive/Chain/Pitch set = paper literal makes the loaded chain a radial clearance per pitch "
      "longer than nominal, but Drive/Sprockets/Seat centre = " +
          text_of(sprockets.seat_centre) +
          " cuts the seats for the nominal pitch: the rollers would ride up the flanks as on worn "
          "sprockets. Choose Seat centre = bottom diameter with both bottom diameters, or Pitch "
          "set = standard.");
  findings.note(p.effects.bush_pin_clearance == Switch::off &&
                    drive.chain.pitch_set != PitchSet::standard,
                "Effects/Bush-pin clearance = off shortens the taut chain of Drive/Chain/Pitch set "
                "= " +
                    text_of(drive.chain.pitch_set) +
                    " by the radial clearance per pitch; with standard it keeps its pitch.");
  findings.note(
      drive.chain.pitch_set == PitchSet::nominal && p.effects.bush_pin_clearance != Switch::off,
      "Drive/Chain/Pitch set = nominal: the loaded chain is a radial clearance per pitch longer "
      "than its sprockets are cut for, and rides up their flanks like a worn chain.");

  for (const Sprocket &sprocket : sprockets.list)
    findings.note(
        !sprocket.mesh.empty(),
        "The " + sprocket.in_words() +
            " touches with the flanks of its mesh; Drive/Sprockets/Tooth form serves only to lay "
            "the chain on it.");

  check_facets(p, effects, findings);
  check_teeth_off_place(p, effects, findings);

  findings.contradiction(
      !p.output.rollers.empty() && p.output.rollers.back() >= drive.n_links,
      "Output/Rollers names roller " +
          std::to_string(p.output.rollers.empty() ? 0 : p.output.rollers.back()) +
          ", but a chain of " + std::to_string(drive.n_links) + " links has the rollers 0 to " +
          std::to_string(drive.n_links - 1) + ".");
}

void check_mesh(const parameters::Mesh &mesh, Findings &findings)
{
  const auto insist_multiple = [&findings](const std::string             &entry,
                                           const parameters::Mesh::Cells &cells,
                                           const unsigned int             of) {
    findings.contradiction(cells.value_or(0) % of != 0,
                           "Mesh/" + entry + " = " + std::to_string(cells.value_or(0)) +
                               " is not a multiple of " + std::to_string(of) + ".");
  };
  insist_multiple("Roller/Cells around", mesh.roller_around, 4);
  insist_multiple("Roller/Cells along", mesh.roller_along, 2);
  insist_multiple("Inner link/Cells around", mesh.inner_link.around, 4);
  insist_multiple("Inner link/Cells along", mesh.inner_link.along, 2);
  insist_multiple("Outer link/Cells around", mesh.outer_link.around, 4);
  insist_multiple("Outer link/Cells along", mesh.outer_link.along, 2);
}

void check_model(const Parameters &p, Findings &findings)
{
  const std::string chosen     = chosen_fidelity(p);
  const bool        clearances = p.model.capabilities().has_clearances;
  const Start       start      = p.drive.layout.start;

  findings.contradiction(
      !clearances && start == Start::concentric,
      "Drive/Layout/Start = concentric centres pins in their bushes, but " + chosen +
          " has no joints; choose taut or settled, or Model/Fidelity = layered.");
  const bool elastic = p.model.capabilities().is_elastic;
  findings.contradiction(
      elastic && p.drive.layout.centre_distance_from == CentreDistanceFrom::pretension,
      "Drive/Layout/Centre distance from = pretension stretches the chain before the start, "
      "which " +
          chosen + " cannot do with its elastic parts; choose given, slack or sag.");
  for (const Sprocket &wheel : p.drive.sprockets.list)
    {
      findings.contradiction(elastic && is_sprung(wheel.held.holder) && start != Start::settled,
                             "The spring of the tensioner, Drive/Wheels/" + wheel.name +
                                 "/Held by = " + text_of(wheel.held.holder) +
                                 ", stretches the chain at the start, for which " + chosen +
                                 " needs Drive/Layout/Start = settled.");
      findings.contradiction(
          wheel.role == parameters::Role::idler &&
              (wheel.resisting_torque || wheel.torque_terms.any_active()),
          "Loads/" + wheel.name + " has a torque, but Drive/Wheels/" + wheel.name +
              "/Role = idler turns freely; choose driven, or leave the torque out.");
    }
  findings.contradiction(elastic && p.drive.sprockets.driver().guide.is_sprung() &&
                             start != Start::settled,
                         "The spring of Drive/Wheels/driver/Guide stretches the chain, for which " +
                             chosen + " needs Drive/Layout/Start = settled.");
  findings.contradiction(p.model.half == SymmetryModel::yes && !elastic,
                         "Model/Symmetry model = true is for elastic bodies: " + chosen +
                             " has none.");
  findings.contradiction(
      elastic && p.mesh.inner_link.along.value_or(4) < 4,
      "Mesh/Inner link/Cells along = 2 leaves one ring of a bush's nodes inside its roller, which "
      "could tilt freely; " +
          chosen + " needs at least 4.");
  findings.contradiction(p.drive.layout.worn_chain == WornChain::shafts_kept &&
                             p.drive.layout.centre_distance_from == CentreDistanceFrom::pretension,
                         "Drive/Layout/Worn chain = shafts kept is for a chain that was laid with "
                         "slack, but Centre distance from = pretension stretches it; choose slack, "
                         "sag or given.");
  findings.contradiction(elastic && p.model.mass_per_pitch,
                         "Model/Mass per pitch in g is that of the parts in " + chosen +
                             ": leave it auto.");
  findings.contradiction(
      elastic && p.model.stiffness_per_pitch && p.model.elastic_links == ElasticLinks::all &&
          p.drive.layout.start != Start::settled,
      "Model/Stiffness per pitch in N/m is that of the parts in " + chosen +
          ", unless some links are rigid (Elastic links = region of interest) or the spans are "
          "stretched before the start (Drive/Layout/Start = settled): leave it auto.");
  findings.contradiction(
      elastic && (p.contact.roller_tooth_stiffness || p.contact.roller_bush_stiffness),
      "Contact/Roller-tooth stiffness in N/m and Roller-bush stiffness in N/m follow from the "
      "elastic parts in " +
          chosen + ": leave them auto" +
          (p.model.capabilities().is_reduced ? "." : " and choose Penalty factor."));
  findings.contradiction(!elastic && p.contact.plate_faces == Switch::on,
                         "Contact/Plate faces = on is for elastic bodies: " + chosen +
                             " has none; choose off.");
  findings.contradiction(!elastic && p.model.elastic_sprockets == Switch::on,
                         "Model/Elastic sprockets = on contradicts " + chosen +
                             ", in which no body is elastic; choose auto or off.");
  const bool has_region = p.model.elastic_links == ElasticLinks::region_of_interest;
  findings.contradiction(has_region && !elastic,
                         "Model/Elastic links = region of interest contradicts " + chosen +
                             ", in which no link is elastic; choose all, or Fidelity = full.");
  findings.contradiction(has_region && p.model.capabilities().is_reduced &&
                             p.model.other_links == OtherLinks::reduced,
                         "Model/Other links = reduced with " + chosen +
                             " leaves no link that is not reduced; choose rigid, or Elastic links "
                             "= all.");
  findings.note(
      start != Start::settled && p.loads.ramp_time > p.time.end,
      "Loads/Ramp time in ms ends after the run: the driver does not reach its full speed.");
  findings.note(
      p.loads.torque_after_step != 0. && !p.loads.torque_step_time,
      "Loads/Torque after step in N m has no effect, since Torque step time in ms is auto.");
}

/// Contact without penalty is for joints both of whose sides are reduced.
void check_enforcement(const Parameters &p, const Effects &effects, Findings &findings)
{
  const parameters::Enforcement enforcement = p.contact.enforcement;
  if (enforcement == parameters::Enforcement::automatic ||
      enforcement == parameters::Enforcement::penalty)
    return;
  const std::string entry = "Contact/Enforcement = " + parameters::text_of(enforcement);
  if (!p.model.capabilities().is_reduced)
    {
      findings.contradiction(true,
                             entry + " is for bodies that deform in modes, which " +
                                 chosen_fidelity(p) +
                                 " has not; choose penalty, or Model/Fidelity = reduced.");
      return;
    }
  findings.contradiction(p.model.elastic_links == ElasticLinks::region_of_interest,
                         entry + " is for chains all of whose links are elastic, but Model/Elastic "
                                 "links = region of interest; choose all, or Enforcement = "
                                 "penalty.");
  for (const auto &[name, effect] :
       {std::pair<const char *, Effect>{"Elastic links", Effect::elastic_links},
        {"Elastic rollers", Effect::elastic_rollers}})
    findings.contradiction(!effects.is_on(effect),
                           entry + " needs elastic links and rollers, but Effects/" + name +
                               " is off; choose on, or Enforcement = penalty.");
  findings.contradiction(enforcement == parameters::Enforcement::exact &&
                             p.effects.contact_damping == Switch::on &&
                             !anything_overlaps(p, true, effects.is_on(Effect::plate_faces)),
                         entry + " lets nothing overlap that could be damped, but Effects/Contact "
                                 "damping is on; choose auto, or Enforcement = penalty.");
  if (enforcement == parameters::Enforcement::exact)
    for (const Sprocket &sprocket : p.drive.sprockets.list)
      findings.contradiction(!sprocket.mesh.empty(),
                             entry + " is for teeth of arcs, but the " + sprocket.in_words() +
                                 " has the flanks of its mesh; choose Enforcement = exact joints.");
  if (p.reduction.modes_up_to)
    findings.contradiction(
        *p.reduction.modes_up_to < least_modes_of_exact_joints,
        "Reduction/Modes up to in kHz = " + to_entry_text(*p.reduction.modes_up_to, unit::kilo) +
            " is too low for " + entry +
            ", in which only modes tell one end of a link what happens at the "
            "other; choose at least " +
            to_entry_text(least_modes_of_exact_joints, unit::kilo) + ", or auto.");
}

/// What is switched on or off in an elastic model must fit together.
void check_elasticity(const Parameters &p, const Effects &effects, Findings &findings)
{
  const parameters::Effects &entries    = p.effects;
  const std::string          chosen     = chosen_fidelity(p);
  const bool                 elastic    = p.model.capabilities().is_elastic;
  const bool                 has_region = p.model.elastic_links == ElasticLinks::region_of_interest;
  std::vector<std::pair<std::string, Switch>> rims;
  for (const Sprocket &sprocket : p.drive.sprockets.list)
    rims.emplace_back("Effects/Elastic " + sprocket.name, sprocket.elastic);
  std::vector<std::pair<std::string, Switch>> all = {
      {"Effects/Elastic links", entries.elastic_links},
      {"Effects/Elastic rollers", entries.elastic_rollers}};
  all.insert(all.end(), rims.begin(), rims.end());
  all.emplace_back("Effects/Plate bending", entries.plate_bending);
  all.emplace_back("Effects/Tooth compliance", entries.tooth_compliance);
  for (const auto &[name, choice] : all)
    findings.contradiction(!elastic && choice == Switch::on,
                           name + " = on contradicts " + chosen +
                               ", in which no body is elastic; choose auto or off, or Model/"
                               "Fidelity = full.");
  if (!elastic)
    return;
  rims.emplace_back("Model/Elastic sprockets", p.model.elastic_sprockets);
  for (const auto &[name, choice] : rims)
    {
      findings.contradiction(
          has_region && choice == Switch::on,
          name + " = on contradicts Elastic links = region of interest, in which all "
                 "sprockets are rigid; choose auto or off, or Elastic links = "
                 "all.");
      findings.contradiction(choice == Switch::on && entries.elastic_rollers == Switch::off,
                             name + " = on needs elastic rollers, whose nodes touch the teeth, but "
                                    "Effects/Elastic rollers = off; choose auto for one of them.");
    }
  if (const Decision &reduced = effects.of(Effect::reduced_bodies); reduced.on)
    {
      const std::string here = " reduced bodies (" + reduced.reason + ")";
      for (const auto &[name, choice] : rims)
        findings.contradiction(choice == Switch::on,
                               name + " = on is not possible with" + here +
                                   "; choose auto or off, or Fidelity = full.");
      findings.contradiction(p.contact.plate_faces == Switch::on,
                             "Contact/Plate faces = on needs plates of finite elements, and not" +
                                 here + "; choose off, or Fidelity = full.");
      findings.contradiction(entries.plate_bending == Switch::off,
                             "Effects/Plate bending = off is for plates of finite elements, and "
                             "not for" +
                                 here + "; choose auto, or Fidelity = full.");
    }
  if (const Decision &teeth = effects.of(Effect::tooth_compliance);
      entries.tooth_compliance == Switch::on)
    findings.contradiction(!teeth.on,
                           "Effects/Tooth compliance = on is for elastic rollers on a rigid "
                           "sprocket, but " +
                               teeth.reason + "; choose auto or off.");
  findings.contradiction(entries.plate_bending == Switch::on &&
                             !effects.is_on(Effect::elastic_links),
                         "Effects/Plate bending = on needs elastic links; choose Effects/Elastic "
                         "links = on, or Plate bending = auto.");
  for (const auto &[name, body] :
       {std::pair<const char *, Decision>{"Elastic links", effects.of(Effect::elastic_links)},
        {"Elastic rollers", effects.of(Effect::elastic_rollers)}})
    findings.contradiction(
        p.model.half == SymmetryModel::yes && !body.on,
        std::string("Model/Symmetry model = true needs elastic links and rollers, "
                    "since rigid ones are whole, but Effects/") +
            name + " is off (" + body.reason + "); choose on, or Symmetry model = auto.");
}

/// What is asked for by its name must be there.
void check_quantities(const Parameters &p, const Effects &effects, Findings &findings)
{
  const parameters::Output &output    = p.output;
  const std::string         chosen    = chosen_fidelity(p);
  const bool                elastic   = p.model.capabilities().is_elastic;
  const auto                asked_for = [](const QuantityGroup group) {
    return "Output/Quantities = " + text_of(group);
  };
  for (const auto &[group, what, decision] :
       {std::tuple<QuantityGroup, const char *, Decision>{
            QuantityGroup::plate_stress, "Elastic links", effects.of(Effect::elastic_links)},
        {QuantityGroup::surface_velocity, "Elastic rollers", effects.of(Effect::elastic_rollers)}})
    findings.contradiction(output.names(group) && !decision.on,
                           asked_for(group) + " needs Effects/" + what + ", which " +
                               (elastic ? "is off (" + decision.reason + "); choose on" :
                                          chosen + " has not; choose Model/Fidelity = full") +
                               ", or leave " + text_of(group) + " out.");
  findings.contradiction(output.names(QuantityGroup::joint_forces) &&
                             !p.model.capabilities().has_clearances,
                         asked_for(QuantityGroup::joint_forces) +
                             " needs joints between rollers, bushes and pins, which " + chosen +
                             " has not; choose Model/Fidelity = layered or full, or leave joint "
                             "forces out.");
  findings.contradiction(output.names(QuantityGroup::fields) && field_interval(p) == 0.,
                         asked_for(QuantityGroup::fields) +
                             " needs an interval, but Output/Field interval in ms = 0 writes "
                             "none; give one above zero, or leave fields out.");
  findings.note(output.names(QuantityGroup::plate_stress) && elastic &&
                    p.effects.plate_bending == Switch::off,
                asked_for(QuantityGroup::plate_stress) +
                    ": plates do not bend out of their planes, since Effects/Plate bending = off.");
  if (!elastic || p.model.elastic_links == ElasticLinks::region_of_interest)
    return;
  for (unsigned int i = 0; i < p.drive.sprockets.list.size(); ++i)
    for (const Needs &needs : all_needs)
      findings.note(needs.sprockets && output.names(needs.group) &&
                        !effects.is_on(Effect::elastic_sprocket, i),
                    asked_for(needs.group) + " would be more accurate with Effects/Elastic " +
                        p.drive.sprockets.list[i].name + ", which is off: " + needs.reason + ".");
}

/// A run that ends with its noise must have what that is made of.
void check_noise(const Parameters &p, Findings &findings)
{
  if (!p.acoustics.noise)
    return;
  const std::string noise = "Acoustics/Noise = on";
  findings.contradiction(!p.output.asks_for(QuantityGroup::roller_motion),
                         noise + " needs the motion of the rollers; add roller motion to "
                                 "Output/Quantities.");
  findings.contradiction(!p.output.rollers.empty() && p.output.rollers.size() < p.drive.n_links,
                         noise + " needs the motion of all rollers, but Output/Rollers names " +
                             std::to_string(p.output.rollers.size()) + " of " +
                             std::to_string(p.drive.n_links) + "; choose all.");
  findings.contradiction(p.loads.driver_speed == 0.,
                         noise + " needs pitch times, but Loads/Driver speed in rad/s = 0.");
}

void check_effects(const Parameters &p, const Effects &effects, Findings &findings)
{
  const parameters::Contact &contact    = p.contact;
  const parameters::Effects &entries    = p.effects;
  const bool                 clearances = p.model.capabilities().has_clearances;
  // what is switched on is off only if its coefficient is zero
  const auto insist = [&](const std::string &name,
                          const Switch       choice,
                          const Effect       effect,
                          const std::string &coefficient_name) {
    findings.contradiction(choice == Switch::on && !effects.is_on(effect),
                           "Effects/" + name + " = on contradicts " + coefficient_name +
                               " = 0; give a value above zero, or choose auto or off.");
  };
  // where all interfaces have coefficients of their own, the one for all does not act
  const bool is_common =
      !contact.roller_tooth_friction ||
      (clearances && (!contact.roller_bush_friction || !contact.bush_pin_friction)) ||
      effects.is_on(Effect::plate_faces) || effects.is_on(Effect::misalignment);
  insist("Friction",
         entries.friction,
         Effect::friction,
         is_common  ? "Contact/Friction coefficient" :
         clearances ? "Contact/Roller-tooth friction, Roller-bush friction and Bush-pin friction" :
                      "Contact/Roller-tooth friction");
  if (anything_overlaps(p, effects.is_on(Effect::exact_teeth), effects.is_on(Effect::plate_faces)))
    insist("Contact damping",
           entries.contact_damping,
           Effect::contact_damping,
           "Contact/Damping ratio");
  insist("Gravity", entries.gravity, Effect::gravity, "Loads/Gravity in m/s2");
  insist("Drag", entries.drag, Effect::drag, "Loads/Drag in 1/s");
  if (!clearances)
    insist(
        "Chain damping", entries.chain_damping, Effect::chain_damping, "Model/Chain damping ratio");
  else
    findings.contradiction(
        entries.chain_damping == Switch::on,
        "Effects/Chain damping = on contradicts " + chosen_fidelity(p) +
            ", which has no bars: Contact/Damping ratio damps its joints. Choose auto or off.");
  for (const auto &[name, choice] :
       {std::pair<const char *, Switch>{"Roller-bush clearance", entries.roller_bush_clearance},
        {"Bush-pin clearance", entries.bush_pin_clearance}})
    findings.contradiction(!clearances && choice == Switch::on,
                           std::string("Effects/") + name + " = on contradicts " +
                               chosen_fidelity(p) +
                               ", which has no joints; choose auto or off, or Model/Fidelity = "
                               "layered.");
}
} // namespace

std::vector<std::string> cross_check(const Parameters &parameters, const Effects &effects)
{
  Findings findings;
  check_times(parameters, effects, findings);
  check_chain(parameters, effects, findings);
  check_model(parameters, findings);
  check_effects(parameters, effects, findings);
  check_elasticity(parameters, effects, findings);
  check_enforcement(parameters, effects, findings);
  check_quantities(parameters, effects, findings);
  check_noise(parameters, findings);
  check_mesh(parameters.mesh, findings);

  for (const auto &more : {refused_switches(parameters, effects),
                           against_misalignment(parameters, effects),
                           against_bush_chain(parameters),
                           against_oil_film(parameters, effects)})
    findings.contradictions.insert(findings.contradictions.end(), more.begin(), more.end());
  std::string message;
  for (const std::string &sentence : findings.contradictions)
    message += (message.empty() ? "" : "\n") + sentence;
  if (!message.empty())
    throw InputError(message);
  return findings.notes;
}
} // namespace chaindrive::model
