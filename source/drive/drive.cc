// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain_mass.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/lay_chain.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace chaindrive::drive
{
using parameters::CentreDistanceFrom;
using parameters::Role;

namespace
{

/// ISO 606: the tooth is narrower than the space between the inner plates.
double tooth_width(const ChainDimensions &chain)
{
  return (chain.pitch <= 12.7e-3 ? 0.93 : 0.95) * chain.inner_width;
}

/// The largest tension that an entry asks for, and the entry.
struct Pull
{
  double      tension; ///< N
  std::string of;      ///< whose tension
  std::string entry;
};

/// What pulls hardest: the load, before or after its step, or the pre-tension.
Pull hardest_pull(const Parameters &parameters, const Drive &drive)
{
  double per_torque = 0., largest = 0.; // tension of each N m that all have, 1/m; tension, N
  for (const Sprocket &sprocket : drive.sprockets)
    if (sprocket.role == Role::driven)
      {
        per_torque += 1. / (0.5 * sprocket.form.pitch_diameter);
        largest += sprocket.largest_torque / (0.5 * sprocket.form.pitch_diameter);
      }
  const double              pitch_radius = 1. / per_torque;
  const parameters::Loads  &loads        = parameters.loads;
  const parameters::Layout &layout       = parameters.drive.layout;
  Pull                      pull{largest, "of the load", "Loads/Resisting torque in N m"};
  const double              after =
      std::abs(loads.torque_after_step) * parameters.drive.chain.share() / pitch_radius;
  if (loads.torque_step_time && after > pull.tension)
    pull = {after, "of the load after its step", "Loads/Torque after step in N m"};
  if (layout.centre_distance_from == CentreDistanceFrom::pretension &&
      layout.pretension > pull.tension)
    pull = {layout.pretension, "before the start", "Drive/Layout/Pretension in N"};
  return pull;
}

/// Refuses a stiffness [N/m] so small that the tension @p pull presses a cylinder deeper into
/// its partner than a quarter of its @p radius [m]: there is no sense in contact beyond that.
void refuse_soft(const std::string &entry,
                 const double       stiffness,
                 const Pull        &pull,
                 const double       radius,
                 const std::string &cylinder)
{
  if (pull.tension > 0.25 * radius * stiffness)
    throw InputError(entry + " = " + to_text(stiffness, 4) + " lets the tension " + pull.of + ", " +
                     to_text(pull.tension, 4) + " N, press the " + cylinder + " " +
                     in_mm(pull.tension / stiffness, 5) +
                     " into its partner; at most a quarter of its radius, " +
                     in_mm(0.25 * radius, 5) + ", is accepted. Choose at least " +
                     to_text_at_least(4. * pull.tension / radius, 4) + " N/m, or a smaller " +
                     pull.entry + ".");
}

/// The torques of loads that @p d, which has its sprockets, meets in operation.
void set_torques(const Parameters &p, Drive &d)
{
  for (Sprocket &sprocket : d.sprockets)
    {
      const double speed   = p.loads.driver_speed * d.driver().form.teeth / sprocket.form.seats();
      sprocket.mean_torque = sprocket.program.mean_torque(p.time.start, p.time.end, speed);
      sprocket.largest_torque = sprocket.program.largest_torque(p.time.start, p.time.end, speed);
    }
}

/// Refuses a load that grows so much with the speed that it would stop its inertia within some time
/// steps.
void refuse_brake(const Drive &d)
{
  constexpr double fastest = 5e3; // 1/s
  const double     speed   = d.driver().program.speed ?
                                 d.driver().program.speed->largest(-1e9, 1e9) * d.driver().form.teeth :
                                 0.;
  for (const Sprocket &sprocket : d.sprockets)
    {
      double steepest = 0.; // N m s
      for (const functions::Term &term : sprocket.program.terms)
        if (term.variable == functions::Variable::speed)
          steepest +=
              sprocket.program.share * term.function->steepest(0., speed / sprocket.form.teeth);
      const double inertia = sprocket.coupling ? sprocket.coupling->behind : sprocket.inertia;
      if (steepest > fastest * inertia)
        throw InputError("Loads/" + sprocket.name + "/Of speed: a torque that grows by " +
                         to_text(steepest, 4) + " N m s stops the inertia of the " +
                         sprocket.title + ", " + to_text(inertia, 4) +
                         " kg m2, faster than a time step resolves; choose smaller values, or an "
                         "inertia of at least " +
                         to_text_at_least(steepest / fastest, 4) + " kg m2.");
    }
}

void append(std::vector<std::string> &notes, const std::vector<std::string> &more)
{
  notes.insert(notes.end(), more.begin(), more.end());
}

/// Refuses stiffnesses of rollers, pins and bushes that the load would push through one another.
void refuse_soft_chain(const Parameters &parameters, const Drive &d)
{
  const Pull load = hardest_pull(parameters, d);
  refuse_soft("Contact/Roller-tooth stiffness in N/m",
              d.roller_tooth_stiffness,
              load,
              0.5 * d.chain.roller_diameter,
              "rollers");
  refuse_soft("Model/Stiffness per pitch in N/m",
              d.stiffness_per_pitch,
              load,
              0.5 * d.chain.pin_diameter,
              "pins");
  if (parameters.model.capabilities().has_clearances)
    refuse_soft("Contact/Roller-bush stiffness in N/m",
                d.roller_bush_stiffness,
                load,
                0.5 * d.chain.bush_diameter,
                "bushes");
}

/// The rounding of the sides of teeth at their tips, ISO 606.
void set_sides(const parameters::Sprockets &sprockets, Drive &d)
{
  d.side_relief =
      sprockets.side_relief.value_or(std::min(0.13 * d.chain.pitch, 0.45 * d.sprocket_width));
  d.side_radius = sprockets.side_radius.value_or(d.chain.pitch);
  if (!(d.side_relief < 0.5 * d.sprocket_width && d.side_relief < d.side_radius))
    throw InputError("Drive/Sprockets/Side relief in mm = " + to_text(1e3 * d.side_relief) +
                     " must be less than half of the width of the teeth, " +
                     in_mm(0.5 * d.sprocket_width, 5) + ", and less than Side radius, " +
                     in_mm(d.side_radius, 5) + ".");
}

/// Chain and sprockets, with what their shafts are given.
void set_chain_and_sprockets(const Parameters &parameters, Drive &d)
{
  const parameters::Sprockets   &sprockets = parameters.drive.sprockets;
  const parameters::Capabilities model     = parameters.model.capabilities();
  d.chain                                  = make_chain(parameters.drive.chain, parameters.effects);
  d.links =
      make_link_pitches(parameters.drive, d.chain.pitch, model.has_clearances, model.is_elastic);
  d.chain = d.links.in(d.chain);
  for (unsigned int i = 0; i < sprockets.list.size(); ++i)
    {
      d.sprockets.push_back(make_sprocket(
          i, sprockets, d.chain, parameters.model.driven_inertia, parameters.drive.chain.share()));
      d.sprockets[i].program =
          make_program(sprockets.list[i],
                       parameters.loads,
                       parameters.time.start,
                       parameters.drive.layout.start == parameters::Start::settled,
                       parameters.folders,
                       parameters.drive.chain.share());
    }
  set_torques(parameters, d);
  d.strands = parameters.drive.chain.strands;
  append(d.notes, d.chain.derived);
  if (!d.links.are_equal())
    d.notes.push_back(d.links.in_words());
  for (const Sprocket &sprocket : d.sprockets)
    append(d.notes, sprocket.form.derived);

  d.sprocket_width = sprockets.width.value_or(tooth_width(d.chain));
  if (!sprockets.width)
    d.notes.push_back("Sprocket width " + in_mm(d.sprocket_width, 5) + " after ISO 606.");
  if (!(d.sprocket_width > 0. && d.sprocket_width < d.chain.inner_width))
    throw InputError("Drive/Sprockets/Width = " + in_mm(d.sprocket_width, 5) +
                     " must be positive and less than the " + in_mm(d.chain.inner_width, 5) +
                     " between the inner plates.");
  set_sides(sprockets, d);
  for (unsigned int i = 0; i < d.sprockets.size(); ++i)
    check_hub(d.sprockets[i], sprockets.list[i], d.notes);
}

/// What yields at the shaft of @p sprocket, which @p given describes and which has its solid; @p
/// share: that of a strand.
void set_shaft(const parameters::Sprocket &given, const double share, Sprocket &sprocket)
{
  sprocket.coupling =
      make_coupling(given, share, sprocket.solid.inertia[2][2], sprocket.given_inertia);
  sprocket.bearing = make_bearing(given, share, sprocket.solid.mass);
  if (sprocket.coupling)
    sprocket.inertia = sprocket.coupling->before + sprocket.coupling->behind;
}

/// Solids, masses and inertias.
void set_solids(const Parameters &parameters, Drive &d)
{
  const double density = parameters.material.density;
  set_chain_mass(parameters, d);
  for (Sprocket &sprocket : d.sprockets)
    {
      const double width = sprocket.carries_plates() ? d.chain.pin_length : d.sprocket_width;
      sprocket.solid     = sprocket_solid(sprocket.form, sprocket.bore, width, density);
      sprocket.inertia   = sprocket.given_inertia.value_or(sprocket.solid.inertia[2][2]);
      set_shaft(parameters.drive.sprockets.list[&sprocket - d.sprockets.data()],
                parameters.drive.chain.share(),
                sprocket);
    }
  refuse_brake(d);
}

/// Stiffnesses of pitch, rollers and teeth under the mean tension of the loads.
void set_stiffnesses(const Parameters &parameters, const StiffnessOf &stiffness_of, Drive &d)
{
  const Material                &steel   = parameters.material;
  const parameters::Model       &given   = parameters.model;
  const parameters::Contact     &contact = parameters.contact;
  const parameters::Capabilities model   = given.capabilities();

  d.nominal_tension = 0.;
  for (const Sprocket &sprocket : d.sprockets)
    if (sprocket.role == Role::driven)
      d.nominal_tension += sprocket.mean_torque / (0.5 * sprocket.form.pitch_diameter);
  for (const Sprocket &sprocket : d.sprockets)
    refuse_soft_shaft(sprocket.name,
                      sprocket.bearing,
                      sprocket.coupling,
                      d.nominal_tension,
                      sprocket.role == Role::driver ?
                          d.nominal_tension * 0.5 * sprocket.form.pitch_diameter :
                          sprocket.mean_torque,
                      d.chain.pitch);
  // contact stiffness depends on the load: without one, a load that strains steel visibly
  d.reference_load          = d.nominal_tension > 0. ?
                                  d.nominal_tension :
                                  1e-5 * steel.youngs_modulus * d.chain.pitch * d.chain.pitch;
  const PartStiffness parts = stiffness_of ? stiffness_of(d, d.reference_load) :
                                             estimated_stiffness(d.chain, d.reference_load, steel);
  append(d.notes, parts.notes);
  d.holes = parts.holes;
  if (!given.stiffness_per_pitch)
    d.curves.per_pitch = parts.curves.per_pitch;
  if (!contact.roller_bush_stiffness)
    d.curves.roller_bush = parts.curves.roller_bush;
  if (!contact.roller_tooth_stiffness)
    d.curves.roller_tooth = parts.curves.roller_tooth;
  // from chord to chord a contact jumps, and with it what it would store at another place
  if (parameters.drive.sprockets.facets > 0)
    for (std::optional<StiffnessCurve> &curve : d.curves.roller_tooth)
      if (curve)
        curve->end = 0.;
  d.stiffness_per_pitch    = given.stiffness_per_pitch.value_or(parts.per_pitch);
  d.roller_bush_stiffness  = contact.roller_bush_stiffness.value_or(parts.roller_bush);
  d.roller_tooth_stiffness = contact.roller_tooth_stiffness.value_or(
      model.has_clearances ? parts.roller_tooth : parts.pressed_roller());
  for (Sprocket &sprocket : d.sprockets)
    if (sprocket.form.flat)
      sprocket.flat_stiffness = sprocket.flat.stiffness.value_or(d.roller_tooth_stiffness);
  for (unsigned int i = 0; i < d.sprockets.size(); ++i)
    d.sprockets[i].tooth_stiffness = contact.tooth_stiffness.value_or(
        parts.teeth.empty() ?
            tooth_stiffness(std::min(d.chain.roller_length, d.sprocket_width), steel) :
            parts.teeth[i]);
  for (unsigned int i = 0; i < parts.tooth_places.size() && !contact.tooth_stiffness; ++i)
    d.sprockets[i].tooth_places = parts.tooth_places[i];
  if (!model.is_elastic) // there the elastic bodies deflect
    refuse_soft_chain(parameters, d);
  d.notes.push_back("Stiffness per pitch " + to_text(d.stiffness_per_pitch, 4) + " N/m (" +
                    (given.stiffness_per_pitch ?
                         "given" :
                         "auto: two links pulled with " + to_text(d.reference_load, 4) + " N") +
                    ")");
}

} // namespace

void refuse_soft_teeth(const Parameters &parameters, const Drive &drive)
{
  if (parameters.contact.tooth_stiffness)
    refuse_soft("Contact/Tooth stiffness in N/m",
                *parameters.contact.tooth_stiffness,
                hardest_pull(parameters, drive),
                0.5 * drive.chain.roller_diameter,
                "rollers");
}

Drive make_drive(const Parameters  &parameters,
                 const StiffnessOf &stiffness_of,
                 const JointShifts &shifts)
{
  Drive d;
  check_tensioner(parameters.drive);
  set_chain_and_sprockets(parameters, d);
  set_solids(parameters, d);
  set_stiffnesses(parameters, stiffness_of, d);
  lay_chain(parameters, shifts, d);
  for (unsigned int i = 0; i < d.sprockets.size(); ++i)
    if (parameters.drive.sprockets.list[i].swing.is_active())
      {
        const Swing swing = make_swing(parameters, i, d.layout);
        d.notes.push_back(in_words(swing, parameters.drive.sprockets, i, d.layout));
        if (!swing.file.empty())
          d.sprockets[i].program.files.push_back(swing.file);
        d.swings.emplace(i, swing);
      }
  return d;
}
} // namespace chaindrive::drive
