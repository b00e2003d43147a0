// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/catalogue.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/hanging_span.h>
#include <chaindrive/drive/ratings.h>
#include <chaindrive/drive/strands.h>
#include <chaindrive/path/span.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace chaindrive::drive
{
using dealii::numbers::PI;
using parameters::Role;

namespace
{
void set_limits(Facts &facts, const unsigned int strands)
{
  const auto &smaller =
      *std::min_element(facts.sprockets.begin(),
                        facts.sprockets.end(),
                        [](const Facts::Sprocket &one, const Facts::Sprocket &other) {
                          return !one.idle && (other.idle || one.teeth < other.teeth);
                        });
  const Ratings limits = ratings_of(facts.chain,
                                    facts.pitch,
                                    smaller.teeth,
                                    smaller.speed * 30. / PI,
                                    uneven_share(strands) * facts.effective_tension);
  facts.rated_power    = limits.power();
  facts.highest_speed =
      limits.speed() * PI / 30. * (static_cast<double>(smaller.teeth) / facts.driver().teeth);
}

/// Sets what concerns sprockets and geometry.
void set_geometry(Facts &facts, const Parameters &p, const Drive &d)
{
  facts.chain          = d.chain.designation;
  facts.links          = static_cast<unsigned int>(d.layout.links.size());
  facts.pitch          = d.chain.pitch;
  facts.loaded_pitch   = d.chain.loaded_pitch();
  facts.mass_per_metre = p.model.mass_per_pitch.value_or(d.mass_per_pitch) / facts.loaded_pitch;
  const CatalogueChain *row = find_chain(d.chain.designation);
  facts.own_dimensions      = has_own_dimensions(d.chain);
  facts.tensile_strength =
      row != nullptr && !facts.own_dimensions ? row->strength_of(d.strands) / d.strands : 0.;
  // the bush ends in the middle of the inner plates; the whole plate carries
  facts.bearing_area = d.chain.pin_diameter * (d.chain.bush_length + d.chain.inner_plate_thickness);

  facts.centre_distance = d.layout.centre_distance();
  const auto first_driven =
      std::find_if(d.sprockets.begin(), d.sprockets.end(), [](const Sprocket &sprocket) {
        return sprocket.role == Role::driven;
      });
  facts.driven          = static_cast<unsigned int>(first_driven - d.sprockets.begin());
  const double z_driver = d.sprockets.front().form.teeth;
  facts.ratio           = first_driven->form.teeth / z_driver;

  const std::size_t        n = d.sprockets.size();
  const path::LinkLengths  lengths{facts.loaded_pitch, facts.loaded_pitch};
  std::vector<path::Wheel> wheels; // of a drive that turns counter-clockwise
  for (std::size_t i = 0; i < n; ++i)
    {
      const Layout::Sprocket &at   = d.layout.sprockets[i];
      const dealii::Point<2>  axis = at.axis();
      const ToothForm        &form = d.sprockets[i].form;
      const dealii::Point<2>  place(axis[0], d.layout.sense * axis[1]);
      if (form.flat)
        wheels.push_back(path::Wheel::flat(0.5 * form.pitch_diameter, place, lengths, at.turn));
      else
        wheels.emplace_back(form.teeth, place, lengths, at.turn);
    }
  // where a line with this normal touches a pitch circle, in the drive as it turns
  const auto touch = [&d](const path::Wheel &wheel, const double tangent) {
    const double angle = path::touching(wheel, tangent);
    return dealii::Point<2>(wheel.centre[0] + wheel.roller_radius * std::cos(angle),
                            d.layout.sense *
                                (wheel.centre[1] + wheel.roller_radius * std::sin(angle)));
  };
  for (std::size_t i = 0; i < n; ++i)
    {
      const path::Wheel  &from = wheels[i], &to = wheels[(i + 1) % n];
      const double        c    = from.centre.distance(to.centre);
      const double        rise = to.turn * to.roller_radius - from.turn * from.roller_radius;
      const Layout::Span &span = d.layout.spans[i];
      facts.spans.push_back({d.sprockets[i].name + "_to_" + d.sprockets[(i + 1) % n].name,
                             Facts::Label::none,
                             span.links,
                             std::sqrt(std::max(0., c * c - rise * rise)),
                             span.slack,
                             span.sag,
                             0.,
                             0.,
                             0.,
                             true,
                             touch(from, path::tangent_angle(from, to)),
                             touch(to, path::tangent_angle(from, to))});
    }
  facts.spans.front().label = Facts::Label::slack;
  facts.spans.back().label  = Facts::Label::tight;

  const auto held = [](const Tensioner &tensioner) {
    const bool arm = tensioner.is_arm();
    return Facts::Held{arm,
                       arm ? tensioner.pivot : dealii::Point<2>(tensioner.direction),
                       arm ? tensioner.sense : 1,
                       tensioner.travel};
  };
  if (d.layout.tensioner)
    {
      facts.tensioner = held(*d.layout.tensioner);
      facts.tensioned = d.layout.tensioner->wheel;
    }
  for (const Guide &guide : d.guides)
    {
      facts.guides.push_back({facts.spans[guide.span].name, guide.polyline(4)});
      if (guide.held)
        facts.guides.back().held = held(*guide.held);
    }

  const double speed = std::abs(p.loads.driver_speed);
  double       pulls = 0.; // of all loads, torque over number of teeth
  for (std::size_t i = 0; i < n; ++i)
    {
      const Sprocket &sprocket = d.sprockets[i];
      const double    z = sprocket.form.seats(), w = speed / (z / z_driver);
      const double    in   = path::tangent_angle(wheels[(i + n - 1) % n], wheels[i]);
      const double    out  = path::tangent_angle(wheels[i], wheels[(i + 1) % n]);
      double          wrap = wheels[i].turn * (out - in);
      wrap -= 2. * PI * std::floor(wrap / (2. * PI));
      const bool   loaded = sprocket.role == Role::driven;
      const double torque = sprocket.mean_torque;
      pulls += loaded ? torque / z : 0.;
      facts.sprockets.push_back({sprocket.name,
                                 sprocket.title,
                                 d.layout.sprockets[i].axis(),
                                 d.layout.sense * wheels[i].turn,
                                 d.layout.sense * path::touching(wheels[i], in),
                                 sprocket.form.flat ? 0 : sprocket.form.teeth,
                                 sprocket.form.pitch_diameter, // teeth do not grow with wear
                                 wrap,
                                 w,
                                 loaded ? torque : 0.,
                                 sprocket.form.flat ? 0. : 1. - std::cos(PI / z),
                                 facts.loaded_pitch * w,
                                 sprocket.inertia,
                                 sprocket.role == Role::idler});
      Facts::Sprocket &known = facts.sprockets.back();
      if (sprocket.coupling)
        known.coupling_frequency = sprocket.coupling->frequency();
      if (sprocket.bearing)
        known.bearing_frequency =
            std::array<double, 2>{{sprocket.bearing->frequency(0), sprocket.bearing->frequency(1)}};
    }
  facts.sprockets.front().torque = pulls * z_driver;
}

/// A span as it hangs in operation. Of its tension all spans stretch: sprockets that turn freely
/// pass it on from one to the next.
HangingSpan
hanging(const Facts &facts, const Facts::Span &span, const Parameters &p, const Drive &d)
{
  const double gravity = p.effects.gravity == parameters::Switch::off ? 0. : p.loads.gravity;
  unsigned int links   = 0;
  for (const Facts::Span &one : facts.spans)
    links += one.links;
  return {span.length, facts.mass_per_metre * gravity, links / d.stiffness_per_pitch};
}

/// The tension of each span besides the one that all keep: what the loads behind it take, N. The
/// driver lets span 0 out, to which no load adds; sprocket i adds its load to span i.
std::vector<double> tensions_of_loads(const Facts &facts)
{
  std::vector<double> tensions(facts.spans.size(), 0.);
  for (std::size_t i = 1; i < tensions.size(); ++i)
    tensions[i] = tensions[i - 1] + (facts.sprockets[i].torque == 0. ?
                                         0. :
                                         2. * PI * facts.sprockets[i].torque /
                                             (facts.sprockets[i].teeth * facts.loaded_pitch));
  return tensions;
}

/// The same where a tensioner presses its wheel against the chain, without the centrifugal tension:
/// its spring balances the two spans beside the wheel, which has no load. Nothing at a stop.
std::optional<double>
tension_of_tensioner(const Facts &facts, const Drive &d, const std::vector<double> &effective)
{
  if (!d.layout.tensioner)
    return {};
  const Tensioner   &tensioner = *d.layout.tensioner;
  const double       travel    = tensioner.travel;
  const Facts::Span &before    = facts.spans[tensioner.wheel - 1],
                    &after     = facts.spans[tensioner.wheel];
  const auto along             = [](const Facts::Span &span) {
    const dealii::Tensor<1, 2> way = span.end - span.begin;
    return way / way.norm();
  };
  const dealii::Tensor<1, 2> way  = tensioner.way(travel);
  const double               push = tensioner.law.elastic(travel) - tensioner.weight * way[1];
  const double               back = (along(before) - along(after)) * way; // by 1 N of tension
  if (travel >= tensioner.law.most || travel <= tensioner.law.least || push <= 0. || back <= 0.)
    return {};
  return push / back - effective[tensioner.wheel];
}

/// The tension that all spans keep besides @p effective, what loads make of each, N: that of the
/// slack span of its weight, with the slack that all stretch adds or the sag that a settled start
/// has found; of pre-tension what stretch leaves of it.
double kept_tension(const Facts               &facts,
                    const Parameters          &p,
                    const Drive               &d,
                    const std::vector<double> &effective)
{
  if (const auto kept = tension_of_tensioner(facts, d, effective))
    return *kept;
  for (const Guide &guide : d.guides)
    if (const auto kept = guide.held ? tension_of(guide, d.layout) : std::nullopt)
      return *kept;
  const parameters::Layout &layout = p.drive.layout;
  HangingSpan               slack  = hanging(facts, facts.slack(), p, d);
  slack.length       = facts.slack().links * facts.loaded_pitch; // slack and sag are between seats
  const bool settled = layout.start == parameters::Start::settled;
  if (settled && slack.weight > 0. && facts.slack().sag > 0.)
    return slack.tension_of_sag(facts.slack().sag);
  double by_load = 0.;
  for (std::size_t i = 0; i < effective.size(); ++i)
    by_load += effective[i] * facts.spans[i].links / d.stiffness_per_pitch;
  if (layout.centre_distance_from == parameters::CentreDistanceFrom::pretension &&
      layout.pretension > 0.)
    {
      // at rest both spans have the pre-tension, and this one hangs with it
      const double sag  = slack.sag(layout.pretension);
      const double hang = 8. * sag * sag / (3. * slack.length);
      return slack.tension(hang - slack.flexibility * layout.pretension + by_load);
    }
  return slack.tension(facts.slack().slack + (settled ? 0. : by_load) +
                       slack.flexibility * facts.centrifugal_tension);
}

/// The tension of the tight span at the driver while the speed grows, when that is fastest: the
/// driver pulls all of the chain that does not sit on it.
double start_tension(const Facts &facts, const Parameters &p, const Drive &d)
{
  const double steepest =
      d.sprockets.front().program.run_up->steepest(p.time.start, p.time.end); // rad/s2
  if (steepest == 0.)
    return 0.;
  const double of_chain = facts.chain_speed / p.loads.driver_speed * steepest; // m/s2
  double       mass =
      facts.mass_per_metre * facts.loaded_pitch * (facts.links - d.layout.sprockets.front().seats);
  for (std::size_t i = 1; i < facts.sprockets.size(); ++i)
    {
      const double radius = 0.5 * facts.sprockets[i].pitch_diameter;
      mass += facts.sprockets[i].inertia / (radius * radius);
    }
  return facts.effective_tension + of_chain * mass;
}

/// How far the chain deflects on a sprocket per change of the tight span's tension @p tight, m/N:
/// its links and teeth (doc/theory.md, section 8). Rollers stay where they are in their seats: the
/// tension changes too fast, and friction holds them. @p kept is the tension of the slack span.
double wrap_flexibility(const Drive    &d,
                        const bool      clearances,
                        const Sprocket &sprocket,
                        const double    seats,
                        const double    tight,
                        const double    kept)
{
  if (tight <= kept)
    return 0.;
  const double alpha = 2. * PI / sprocket.form.teeth;
  const double tooth =
      1. / d.roller_tooth_stiffness + (clearances ? 1. / d.roller_bush_stiffness : 0.);
  double q   = std::pow(kept / tight, 1. / seats); // of the tensions behind and before a roller
  double phi = std::atan2(q * std::sin(alpha), 1. - q * std::cos(alpha));
  // rollers bear on their seats, which end there
  if (const double least = 0.5 * PI - 0.5 * alpha - sprocket.form.seat_half_angle; phi < least)
    {
      phi = least;
      q   = std::sin(phi) / std::sin(phi + alpha);
    }
  const double share = std::sin(alpha) / std::sin(phi + alpha); // of the tension, for the tooth
  return (q * q / d.stiffness_per_pitch + share * share * tooth) / (1. - q * q);
}

/// The lowest frequency of the inertias of all sprockets on the spans that pull them, the driver
/// held: of two the driven inertia on the tight span. A span is a spring of so many pitches, with
/// what the chain deflects on the sprockets whose tighter side it is; of the chain what sits on a
/// sprocket moves with it, and of the span that pulls it a third. The slack span is no spring.
///
/// Displacements u of the chain at the sprockets are F M u omega^2 with masses M and flexibilities
/// F: of i and j what lies between the driver and the nearer one. The largest eigenvalue of F M by
/// the power method.
///
/// Behind a coupling the inertia is a mass of its own, on its sprocket's flexibility and that of
/// the spring, r^2 / k. The coupling of a driver is a spring between its sprocket, which is such a
/// mass too, and what is held.
double driven_frequency(const Facts &facts, const Parameters &p, const Drive &d)
{
  const std::size_t   n          = facts.sprockets.size();
  const double        pitch_mass = facts.mass_per_metre * facts.loaded_pitch;
  std::vector<double> mass(n, 0.), to_driver(n + 1, 0.); // kg; m/N
  for (std::size_t i = n - 1; i > 0; --i)
    {
      const double radius   = 0.5 * facts.sprockets[i].pitch_diameter;
      const double links    = facts.spans[i].length / facts.loaded_pitch; // mean over a pitch
      const auto  &coupling = d.sprockets[i].coupling;
      const double inertia  = coupling ? coupling->before : facts.sprockets[i].inertia;
      // the inertia of a drum hangs on friction alone
      mass[i] = (d.sprockets[i].form.flat ? 0. : inertia / (radius * radius)) +
                pitch_mass * (d.layout.sprockets[i].seats + links / 3.);
      const auto on = [&](const std::size_t sprocket, const double tight, const double kept) {
        return wrap_flexibility(d,
                                p.model.capabilities().has_clearances,
                                d.sprockets[sprocket],
                                d.layout.sprockets[sprocket].seats,
                                tight - facts.centrifugal_tension,
                                kept - facts.centrifugal_tension);
      };
      double flexibility = links / d.stiffness_per_pitch;
      if (i == n - 1)
        flexibility += on(0, facts.spans[i].tension, facts.spans[0].tension);
      flexibility += on(i, facts.spans[i].tension, facts.spans[i - 1].tension);
      to_driver[i] = to_driver[i + 1] + flexibility;
    }
  // masses, each with the sprocket whose flexibility to the driver is its way, and what is behind
  std::vector<std::size_t> at;
  std::vector<double>      behind(n, 0.);
  double                   before_all = 0.;
  for (std::size_t i = 0; i < n; ++i)
    at.push_back(i == 0 ? n : i);
  for (std::size_t i = 0; i < n; ++i)
    if (const auto &coupling = d.sprockets[i].coupling)
      {
        const double square = std::pow(0.5 * facts.sprockets[i].pitch_diameter, 2);
        if (i == 0)
          {
            before_all = square / coupling->stiffness;
            mass[0]    = coupling->before / square + pitch_mass * d.layout.sprockets[0].seats;
            continue;
          }
        at.push_back(i);
        mass.push_back(coupling->behind / square);
        behind.push_back(square / coupling->stiffness);
      }
  const std::size_t   first = before_all > 0. ? 0 : 1, all = at.size();
  std::vector<double> u(all, 1.), next(all, 0.);
  double              largest = 0.;
  for (unsigned int step = 0; step < 200; ++step)
    {
      double greatest = 0.;
      for (std::size_t i = first; i < all; ++i)
        {
          next[i] = 0.;
          for (std::size_t j = first; j < all; ++j)
            next[i] +=
                (to_driver[std::max(at[i], at[j])] + before_all + (i == j ? behind[i] : 0.)) *
                mass[j] * u[j];
          greatest = std::max(greatest, next[i]);
        }
      for (std::size_t i = first; i < all; ++i)
        u[i] = next[i] / greatest;
      const bool found = std::abs(greatest - largest) <= 1e-14 * greatest;
      largest          = greatest;
      if (found)
        break;
    }
  return std::sqrt(1. / largest) / (2. * PI);
}
} // namespace

double
string_frequency(const double length, const double mass, const double tension, const double speed)
{
  if (tension <= 0.)
    return 0.;
  const double wave = std::sqrt(tension / mass); // f = c / 2L (1 - v^2 / c^2)
  return 0.5 * wave / length * (1. - speed * speed / (wave * wave));
}

double
string_resonance(const double length, const double mass, const double tension, const double pitch)
{
  // with c^2 = T / m + v^2 the frequency is T / (2 L m c), and v / pitch is to be equal to it
  const double square = std::max(0., tension) / mass;
  const double right  = 0.5 * pitch * square / length; // v sqrt(square + v^2) = right
  return std::sqrt(0.5 * (std::sqrt(square * square + 4. * right * right) - square));
}

double parabola_sag(const double length, const double slack)
{
  return std::sqrt(0.375 * length * std::max(0., slack)); // slack = 8 sag^2 / (3 length)
}

Facts make_facts(const Parameters &p, const Drive &d)
{
  Facts facts;
  set_geometry(facts, p, d);
  const double z1 = facts.driver().teeth;
  facts.power     = 0.;
  for (const Facts::Sprocket &sprocket : facts.sprockets)
    facts.power += &sprocket == &facts.driver() ? 0. : sprocket.torque * sprocket.speed;
  facts.tooth_frequency     = z1 * facts.driver().speed / (2. * PI);
  facts.pitch_time          = facts.tooth_frequency > 0. ? 1. / facts.tooth_frequency : 0.;
  facts.chain_speed         = facts.loaded_pitch * facts.tooth_frequency;
  facts.centrifugal_tension = facts.mass_per_metre * facts.chain_speed * facts.chain_speed;

  const std::vector<double> effective = tensions_of_loads(facts);
  facts.effective_tension             = effective.back();
  const double kept                   = kept_tension(facts, p, d, effective);
  facts.slack_tension_unloaded =
      kept_tension(facts, p, d, std::vector<double>(effective.size(), 0.));
  for (std::size_t i = 0; i < facts.spans.size(); ++i)
    {
      Facts::Span &span      = facts.spans[i];
      const double pull      = effective[i] + kept;
      span.tension           = pull + facts.centrifugal_tension;
      const HangingSpan hung = hanging(facts, span, p, d);
      const LowestMode  mode = lowest_mode(hung, pull);
      const double      wave = span.length / mode.factor; // of a string with that frequency
      span.symmetric         = mode.symmetric;
      span.frequency =
          string_frequency(wave, facts.mass_per_metre, span.tension, facts.chain_speed);
      span.resonance = string_resonance(wave, facts.mass_per_metre, pull, facts.loaded_pitch) * 2. *
                       PI / (z1 * facts.loaded_pitch);
    }
  const double tension = facts.tight().tension;
  facts.joint_pressure = tension / facts.bearing_area;
  facts.safety         = tension > 0. ? facts.tensile_strength / tension : 0.;
  for (std::size_t i = 0; i < facts.sprockets.size(); ++i)
    {
      const double out = effective[i] + kept,
                   in  = effective[(i + effective.size() - 1) % effective.size()] + kept;
      // the spans include the angle by which the wrap differs from half a turn
      facts.sprockets[i].load =
          std::sqrt(out * out + in * in + 2. * out * in * std::cos(facts.sprockets[i].wrap - PI));
    }
  facts.shaft_load     = facts.loaded().load;
  facts.driven_inertia = facts.loaded().inertia;
  facts.start_tension  = start_tension(facts, p, d);
  facts.full_speed_from =
      functions::last_breakpoint(*d.sprockets.front().program.run_up, p.time.start);
  facts.driven_frequency = driven_frequency(facts, p, d);
  facts.driven_resonance = 2. * PI * facts.driven_frequency / z1;
  set_limits(facts, d.strands);
  add_strands(facts, d.strands);
  return facts;
}

unsigned int pitches_per_resonance(const Facts &facts)
{
  const double pitches = facts.tooth_frequency / facts.driven_frequency;
  return pitches > 1. && pitches < 1e6 ? static_cast<unsigned int>(std::ceil(pitches)) : 1;
}
} // namespace chaindrive::drive
