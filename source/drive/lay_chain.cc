// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/hanging_span.h>
#include <chaindrive/drive/lay_chain.h>
#include <chaindrive/drive/rest.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace chaindrive::drive
{
using parameters::CentreDistanceFrom;
using parameters::Role;

namespace
{
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
  chain.curves          = d.curves;
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

/// Whether teeth of any sprocket do not stand in their places.
bool has_shifted_gaps(const Drive &d)
{
  return std::any_of(d.sprockets.begin(), d.sprockets.end(), [](const Sprocket &sprocket) {
    return !sprocket.form.shifted.empty();
  });
}

std::vector<ToothForm> forms_of(const std::vector<Sprocket> &sprockets)
{
  std::vector<ToothForm> forms;
  forms.reserve(sprockets.size());
  for (const Sprocket &sprocket : sprockets)
    forms.push_back(sprocket.form);
  return forms;
}
} // namespace

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
  std::optional<Guide> pressed =
      make_pressed_guide(entries, d.chain, forms, d.layout, gravity(parameters));
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
  for (Guide &guide : make_guides(parameters.drive, d.chain, forms_of(d.sprockets), d.layout))
    d.guides.push_back(std::move(guide));
}
} // namespace chaindrive::drive
