// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain_mass.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/hanging_span.h>
#include <chaindrive/drive/rest.h>
#include <chaindrive/drive/strands.h>
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

/// The acceleration that acts, m/s2.
double gravity(const Parameters &p)
{
  return acts(p.effects.gravity, p.loads.gravity) ? p.loads.gravity : 0.;
}

/// The chain of the simple or the layered model for bring_to_rest().
RestingChain resting_chain(const Parameters &p, const Drive &d)
{
  const double mass = p.model.mass_per_pitch.value_or(d.mass_per_pitch);
  RestingChain chain;
  chain.deviations      = d.links.deviations;
  chain.weight          = mass * gravity(p);
  chain.roller_radius   = 0.5 * d.chain.roller_diameter;
  chain.tooth_stiffness = d.roller_tooth_stiffness;
  if (!p.model.capabilities().has_clearances)
    {
      const double mean     = d.chain.loaded_pitch();
      chain.length          = {mean, mean};
      chain.inner_stiffness = chain.outer_stiffness = d.stiffness_per_pitch;
      chain.bush_clearance = chain.bush_stiffness = 0.;
      return chain;
    }
  chain.length          = {d.chain.loaded_inner_pitch(), d.chain.loaded_outer_pitch()};
  chain.outer_stiffness = 0.5 * d.stiffness_per_pitch; // two joints in series
  chain.inner_stiffness = 1e3 * d.stiffness_per_pitch; // as good as rigid
  chain.bush_clearance  = d.chain.roller_clearance();
  chain.bush_stiffness  = d.roller_bush_stiffness;
  return chain;
}

/// The entries of a drive whose chain has worn while its shafts stayed where slack or sag of the
/// new chain had put them: their distance, or the place of the wheel that is clamped, is given. @p
/// lay finds the layout of entries and a chain.
template <typename Lay>
parameters::Drive worn_drive(const Parameters &parameters, const Lay &lay, Drive &d)
{
  parameters::Drive         entries = parameters.drive;
  const parameters::Layout &layout  = entries.layout;
  if (layout.worn_chain != parameters::WornChain::shafts_kept || entries.chain.elongation == 0. ||
      layout.centre_distance_from == CentreDistanceFrom::given)
    return entries;
  parameters::Drive as_new = entries;
  as_new.chain.elongation  = 0.;
  const Layout laid =
      lay(without_tensioner(as_new), d.links.in(make_chain(as_new.chain, parameters.effects)));
  const std::string from =
      ", from " + text_of(layout.centre_distance_from) + " of the chain when it was new.";
  entries.layout.centre_distance_from = CentreDistanceFrom::given;
  if (laid.clamped)
    {
      const Tensioner       &at     = *laid.clamped;
      const dealii::Point<2> centre = at.centre(at.travel);
      parameters::Sprocket  &wheel  = entries.sprockets.list[at.wheel];
      wheel.centre                  = std::array<double, 2>{{centre[0], laid.sense * centre[1]}};
      wheel.held.holder             = parameters::Holder::bearing;
      d.notes.push_back("Travel of the " + text_of(at.holder) + " " + at.with_unit(at.travel) +
                        from);
      return entries;
    }
  entries.layout.centre_distance = laid.centre_distance();
  d.notes.push_back("Centre distance " + to_text(1e3 * entries.layout.centre_distance, 7) + " mm" +
                    from);
  return entries;
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

/// The speed of the driver from which a settled start goes, rad/s.
double speed_at_start(const Parameters &p, const ShaftProgram &driver)
{
  if (p.drive.layout.start != parameters::Start::settled)
    return p.loads.driver_speed;
  const double speed = driver.speed->value(p.time.start);
  if (speed < 0.)
    throw InputError("Drive/Layout/Start = settled begins at the speed that Loads/driver gives at "
                     "the start, " +
                     to_text(speed) +
                     " rad/s: it must not be below zero; choose another one, or "
                     "taut.");
  return speed;
}

/// What may keep a drive from being settled, in a sentence after the refusal; else nothing.
std::string reason_to_fail(const parameters::Chain &chain, const Layout &layout)
{
  const double slack = layout.slack().slack;
  std::string  text;
  if (chain.elongation > 0.01)
    text += " Drive/Chain/Elongation in percent = " + to_text(100. * chain.elongation) +
            " lets rollers ride up the teeth; a chain is replaced at 3 or less.";
  if (slack > 0.03 * layout.centre_distance())
    text +=
        " The slack span has " + in_mm(slack, 5) +
        " of slack, by Drive/Layout/Slack in mm, Sag in percent, Centre distance in mm or wear: "
        "take less.";
  return text;
}

/// Greatest distance of the joints in @p span from the straight line between its ends, m.
double depth(const Layout &layout, const Layout::Span &span)
{
  const auto &from = layout.joints[span.first].bush;
  double      most = 0.;
  for (unsigned int i = 1; i < span.links; ++i)
    {
      const auto &joint = layout.joints[(span.first + i) % layout.joints.size()].bush;
      most              = std::max(most, std::abs((joint - from) * span.normal));
    }
  return most;
}

/// Lays the settled drive of @p d anew with other sags until it has the one of @p entries. Rollers
/// climb in their seats and clearances open when a chain is loaded, which changes its slack, to
/// which the square of the sag is proportional: secants of that. @p lay finds the settled layout.
template <typename Lay>
void keep_sag(const parameters::Drive &entries, Drive &d, const Lay &lay)
{
  const double      wanted = entries.layout.sag, asked = wanted * wanted;
  parameters::Drive trial = entries;
  double            tried = asked, slope = 1., now = relative_sag(d.layout), last = now;
  double            low = 0., high = std::numeric_limits<double>::infinity(); // of what is tried
  for (unsigned int i = 0; i < 12 && std::abs(last / wanted - 1.) > 5e-4; ++i)
    {
      (last > wanted ? high : low) = tried;
      double next = std::clamp(tried + (asked - last * last) / slope, 0.25 * tried, 4. * tried);
      if (!(next > low && next < high))
        next = std::sqrt(low * high);
      trial.layout.sag    = std::sqrt(next);
      const double before = last;
      try
        {
          const Layout layout = lay(trial);
          last                = relative_sag(layout);
          if (std::abs(last - wanted) < std::abs(now - wanted))
            {
              d.layout = layout;
              now      = last;
            }
        }
      catch (const InputError &) // the drive can be settled, but not with less slack
        {
          break;
        }
      const double rise = (last * last - before * before) / (next - tried);
      slope             = rise > 0.05 ? rise : slope;
      tried             = next;
    }
  if (std::abs(now / wanted - 1.) > 1e-2)
    d.notes.push_back("Drive/Layout/Sag in percent = " + to_text(100. * wanted) +
                      ": the settled slack span hangs by " + to_text(100. * now, 3) +
                      " %, for loaded joints and seats change the slack by more than that sag.");
}

void append(std::vector<std::string> &notes, const std::vector<std::string> &more)
{
  notes.insert(notes.end(), more.begin(), more.end());
}

/// The driver is held, and on each sprocket that has a load the torque [N m] acts that @p
/// torque_of it tells, counter-clockwise in a drive that turns so.
template <typename TorqueOf>
std::vector<RestingWheel> resting_wheels(const std::vector<Sprocket> &sprockets,
                                         const Layout                &layout,
                                         const TorqueOf              &torque_of)
{
  std::vector<RestingWheel> wheels;
  wheels.reserve(sprockets.size());
  for (std::size_t i = 0; i < sprockets.size(); ++i)
    {
      wheels.push_back(resting_sprocket(sprockets[i].form,
                                        sprockets[i].role == Role::driver,
                                        sprockets[i].role == Role::driven ?
                                            layout.sprockets[i].turn * torque_of(sprockets[i]) :
                                            0.));
      if (sprockets[i].bearing)
        wheels.back().bearing = sprockets[i].bearing->stiffness;
      if (sprockets[i].carries_plates())
        wheels.back().plates = {
            0.5 * (sprockets[i].form.pitch_diameter - sprockets[i].form.root_diameter),
            sprockets[i].flat_stiffness};
    }
  return wheels;
}

/// The wheels of @p d, which are not loaded.
std::vector<RestingWheel> unloaded(const Drive &d)
{
  return resting_wheels(d.sprockets, d.layout, [](const Sprocket &) { return 0.; });
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

/// Whether teeth of any sprocket do not stand in their places.
bool has_shifted_gaps(const Drive &d)
{
  return std::any_of(d.sprockets.begin(), d.sprockets.end(), [](const Sprocket &sprocket) {
    return !sprocket.form.shifted.empty();
  });
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
      if (const parameters::Sprocket &wheel = sprockets.list[i];
          wheel.is_flat() && wheel.flat.runs_on == parameters::RunsOn::plates && model.is_elastic &&
          !model.is_reduced)
        throw InputError(
            "Drive/Wheels/" + wheel.name +
            "/Flat/Runs on = plates is for the fidelities simple, layered and reduced; "
            "choose one of these, or rollers.");
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
  if (d.strands > 1)
    d.notes.push_back(in_words_of_strands(d.strands));
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
  if (!model.is_elastic) // there the elastic bodies deflect
    refuse_soft_chain(parameters, d);
  d.notes.push_back("Stiffness per pitch " + to_text(d.stiffness_per_pitch, 4) + " N/m (" +
                    (given.stiffness_per_pitch ?
                         "given" :
                         "auto: two links pulled with " + to_text(d.reference_load, 4) + " N") +
                    ")");
}

std::vector<ToothForm> forms_of(const std::vector<Sprocket> &sprockets)
{
  std::vector<ToothForm> forms;
  forms.reserve(sprockets.size());
  for (const Sprocket &sprocket : sprockets)
    forms.push_back(sprocket.form);
  return forms;
}

/// Lays the chain: without load, at rest with its pre-tension, or as it runs.
void lay_chain(const Parameters &parameters, const JointShifts &shifts, Drive &d)
{
  const parameters::Model &given = parameters.model;
  std::vector<ToothForm>   forms = forms_of(d.sprockets); // laid as drawn, and fitted below
  for (ToothForm &form : forms)
    form.shifted.clear();
  const double mass  = given.mass_per_pitch.value_or(d.mass_per_pitch) / d.chain.loaded_pitch();
  const double speed = parameters.loads.driver_speed * 0.5 * forms[0].pitch_diameter;
  const double start_speed = speed_at_start(parameters, d.driver().program);
  const auto   lay         = [&](const parameters::Drive &entries, const ChainDimensions &chain) {
    Layout layout = make_layout(entries,
                                chain,
                                forms,
                                given.capabilities().has_clearances,
                                d.stiffness_per_pitch,
                                start_speed,
                                d.nominal_tension,
                                gravity(parameters) == 0.,
                                mass * gravity(parameters),
                                mass * speed * speed);
    shift_joints(layout, d.links);
    return layout;
  };
  parameters::Drive   entries   = worn_drive(parameters, lay, d);
  parameters::Layout &layout    = entries.layout;
  const unsigned int  tensioned = tensioned_wheel(entries.sprockets);
  const bool          clamped   = is_clamped(entries.sprockets.list[tensioned].held.holder);
  if (tensioned > 0 && !clamped && layout.centre_distance_from == CentreDistanceFrom::slack)
    { // the tensioner takes up the slack that there is without its travel
      layout.centre_distance      = lay(without_tensioner(entries), d.chain).centre_distance();
      layout.centre_distance_from = CentreDistanceFrom::given;
      d.notes.push_back("Centre distance " + to_text(layout.centre_distance * 1e3, 7) +
                        " mm, from slack where the tensioner has no travel.");
    }
  const bool settled   = layout.start == parameters::Start::settled;
  const bool stretched = layout.centre_distance_from == CentreDistanceFrom::pretension;
  if (settled && stretched) // shafts are where the drive at rest has its pre-tension
    layout.start = parameters::Start::taut;
  d.layout = lay(entries, d.chain);
  if (d.layout.tensioner)
    d.layout.tensioner->carry(d.sprockets[d.layout.tensioner->wheel].solid.mass,
                              gravity(parameters));
  std::optional<Guide> pressed = make_pressed_guide(
      entries, d.chain, forms, d.layout, gravity(parameters), given.capabilities());
  const auto at_rest =
      pressed ? std::make_optional(resting_guide(*pressed, d.chain)) : std::nullopt;
  if (pressed && !settled)
    bring_to_rest(d.layout, resting_chain(parameters, d), unloaded(d), *at_rest);
  else if (d.layout.tensioner && !settled)
    bring_to_rest(d.layout, resting_chain(parameters, d), unloaded(d));
  else if ((!d.links.are_equal() || has_shifted_gaps(d)) && !settled &&
           !(stretched && layout.pretension > 0.))
    fit_links(d.layout, resting_chain(parameters, d), unloaded(d));
  if (stretched && layout.pretension > 0.)
    bring_to_rest(d.layout, resting_chain(parameters, d), unloaded(d), layout.pretension);
  if (settled)
    {
      RestingChain chain  = resting_chain(parameters, d);
      chain.shifts        = shifts;
      const Facts facts   = make_facts(parameters, d);
      const auto  settled = [&](Layout start) {
        try
          {
            settle(start,
                   chain,
                   resting_wheels(d.sprockets,
                                  start,
                                  [&](const Sprocket &sprocket) {
                                    return -start.sense *
                                           sprocket.program.lasting_torque(
                                               0.,
                                               parameters.time.start,
                                               start_speed * forms[0].teeth / sprocket.form.teeth);
                                  }),
                   {std::abs(start_speed),
                    given.mass_per_pitch.value_or(d.mass_per_pitch),
                    facts.tooth_frequency < facts.driven_frequency},
                   at_rest ? &*at_rest : nullptr);
          }
        catch (const InputError &error)
          {
            throw InputError(error.what() + reason_to_fail(parameters.drive.chain, start));
          }
        for (Layout::Span &span : start.spans)
          span.sag = span.straight ? span.sag : depth(start, span);
        return start;
      };
      d.layout = settled(d.layout);
      if (keeps_sag(layout) && layout.sag > 0. && gravity(parameters) > 0.)
        keep_sag(entries, d, [&](const parameters::Drive &trial) {
          return settled(lay(trial, d.chain));
        });
    }
  for (const auto &tensioner : {d.layout.tensioner, d.layout.clamped})
    if (tensioner)
      d.notes.push_back(tensioner->in_words(
          d.sprockets[tensioner->wheel].title, d.layout.slack().slack, d.strands));
  if (pressed)
    {
      d.notes.push_back(pressed->in_words(d.layout.slack().slack, d.strands));
      d.guides.push_back(std::move(*pressed));
    }
  if (layout.centre_distance_from != CentreDistanceFrom::given && !clamped)
    d.notes.push_back("Centre distance " + to_text(d.layout.centre_distance() * 1e3, 7) +
                      " mm, from " + text_of(layout.centre_distance_from) + ".");
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
  for (Guide &guide : make_guides(parameters.drive,
                                  d.chain,
                                  forms_of(d.sprockets),
                                  d.layout,
                                  parameters.model.capabilities()))
    d.guides.push_back(std::move(guide));
  return d;
}
} // namespace chaindrive::drive
