// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/catalogue.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/hanging_span.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

namespace chaindrive::drive
{
using dealii::numbers::PI;
using parameters::Role;

namespace
{
/// The usual limits of Shigley's Mechanical Engineering Design, chapter 17, after the American
/// Chain Association: power that link plates endure, power that rollers and bushes endure under
/// their impacts, and the speed at which joints begin to gall. They are regressions in inches,
/// pounds and revolutions per minute for the sizes 25 to 240; of other standards' chains of the
/// same pitch they are a guide.
struct UsualLimits
{
  double pitch;             ///< inches
  double teeth, rpm;        ///< of the smaller sprocket
  double tension;           ///< pounds
  bool   light, rollerless; ///< size 41; sizes 25 and 35

  double power() const ///< W
  {
    const double plates = 0.004 * std::pow(teeth, 1.08) * std::pow(rpm, 0.9) *
                          std::pow(pitch, 3. - 0.07 * pitch) * (light ? 0.55 : 1.);
    const double factor  = light ? 3.4 : (rollerless ? 29. : 17.);
    const double rollers = 1000. * factor * std::pow(teeth, 1.5) * std::pow(pitch, 0.8) /
                           std::pow(std::max(rpm, 1.), 1.5);
    return 745.7 * std::min(plates, rollers);
  }

  double speed() const ///< rpm
  {
    const double inside =
        82.5 / (std::pow(7.95, pitch) * std::pow(1.0278, teeth) * std::pow(1.323, tension / 1000.));
    return 1000. * std::pow(inside, 1. / (1.59 * std::log10(pitch) + 1.873));
  }
};

void set_limits(Facts &facts)
{
  const bool        driver_smaller = facts.sprockets[0].teeth <= facts.sprockets[1].teeth;
  const auto       &smaller        = facts.sprockets[driver_smaller ? 0 : 1];
  const UsualLimits limits{facts.pitch / 0.0254,
                           static_cast<double>(smaller.teeth),
                           smaller.speed * 30. / PI,
                           facts.effective_tension / 4.448,
                           facts.chain == "41" || facts.chain == "085",
                           facts.pitch < 10e-3};
  facts.rated_power   = limits.power();
  facts.highest_speed = limits.speed() * PI / 30. * (driver_smaller ? 1. : facts.ratio);
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
  facts.tensile_strength    = row != nullptr && !facts.own_dimensions ? row->tensile_strength : 0.;
  // the bush ends in the middle of the inner plates; the whole plate carries
  facts.bearing_area = d.chain.pin_diameter * (d.chain.bush_length + d.chain.inner_plate_thickness);

  facts.centre_distance = d.layout.centre_distance();
  const double driver = d.with(Role::driver).form.teeth, driven = d.with(Role::driven).form.teeth;
  facts.ratio         = driven / driver;
  const auto   radius = [&](const double z) { return 0.5 * facts.loaded_pitch / std::sin(PI / z); };
  const double rise   = radius(driven) - radius(driver);
  const double incline = std::asin(std::clamp(rise / facts.centre_distance, -1., 1.));
  const double speed = std::abs(p.loads.driver_speed), torque = p.loads.resisting_torque;
  const auto   sprocket = [&](const Role role, const double z, const double wrap) {
    const double w = role == Role::driver ? speed : speed / facts.ratio;
    return Facts::Sprocket{parameters::in_words(role),
                           static_cast<unsigned int>(z),
                           d.with(role).form.pitch_diameter, // teeth do not grow with wear
                           wrap,
                           w,
                           role == Role::driver ? torque / facts.ratio : torque,
                           1. - std::cos(PI / z),
                           facts.loaded_pitch * w};
  };
  facts.sprockets = {{sprocket(Role::driver, driver, PI - 2. * incline),
                      sprocket(Role::driven, driven, PI + 2. * incline)}};
  const double straight =
      std::sqrt(std::max(0., facts.centre_distance * facts.centre_distance - rise * rise));
  for (const Layout::Span &span : d.layout.spans)
    facts.spans.push_back(
        {span.tight, span.links, straight, span.slack, span.sag, 0., 0., 0., true});
}

/// A span as it hangs in operation. Of its tension both spans stretch: the driven sprocket, which
/// turns freely, passes it on to the other one.
HangingSpan
hanging(const Facts &facts, const Facts::Span &span, const Parameters &p, const Drive &d)
{
  const double gravity = p.effects.gravity == parameters::Switch::off ? 0. : p.loads.gravity;
  return {span.length,
          facts.mass_per_metre * gravity,
          (facts.span(true).links + facts.span(false).links) / d.stiffness_per_pitch};
}

/// The tension that the slack span keeps, and the tight one has besides the effective tension: of
/// its weight, with the slack that all stretch adds or the sag that a settled start has found; of
/// pre-tension what stretch leaves of it. @p effective: what the tight one has besides. N.
double kept_tension(const Facts &facts, const Parameters &p, const Drive &d, const double effective)
{
  const parameters::Layout &layout = p.drive.layout;
  HangingSpan               slack  = hanging(facts, facts.span(false), p, d);
  slack.length = facts.span(false).links * facts.loaded_pitch; // slack and sag are between seats
  const bool settled = layout.start == parameters::Start::settled;
  if (settled && slack.weight > 0. && facts.span(false).sag > 0.)
    return slack.tension_of_sag(facts.span(false).sag);
  const double by_load = effective * facts.span(true).links / d.stiffness_per_pitch;
  if (layout.centre_distance_from == parameters::CentreDistanceFrom::pretension &&
      layout.pretension > 0.)
    {
      // at rest both spans have the pre-tension, and this one hangs with it
      const double sag  = slack.sag(layout.pretension);
      const double hang = 8. * sag * sag / (3. * slack.length);
      return slack.tension(hang - slack.flexibility * layout.pretension + by_load);
    }
  return slack.tension(facts.span(false).slack + (settled ? 0. : by_load) +
                       slack.flexibility * facts.centrifugal_tension);
}

/// The tension of the tight span at the driver while the speed grows, when that is fastest: the
/// driver pulls all of the chain that does not sit on it.
double start_tension(const Facts &facts, const Parameters &p, const Drive &d)
{
  const double steepest = d.programs.speed->steepest(p.time.start, p.time.end); // rad/s2
  if (steepest == 0.)
    return 0.;
  const double of_chain = facts.chain_speed / p.loads.driver_speed * steepest; // m/s2
  const double radius   = 0.5 * facts.sprockets[1].pitch_diameter;
  const double mass =
      facts.mass_per_metre * facts.loaded_pitch * (facts.links - d.layout.sprockets.front().seats);
  return facts.effective_tension + of_chain * (mass + facts.driven_inertia / (radius * radius));
}

/// How far the chain gives way on a sprocket per change of the tight span's tension @p tight, m/N:
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

/// The driven inertia on the tight span, a spring of so many pitches between two wraps; of the
/// chain what sits on the sprocket moves with it, of the span a third.
double driven_frequency(const Facts &facts, const Parameters &p, const Drive &d)
{
  const double pitch_mass = facts.mass_per_metre * facts.loaded_pitch;
  const double radius     = 0.5 * facts.sprockets[1].pitch_diameter;
  const double links      = facts.span(true).length / facts.loaded_pitch; // mean over a pitch
  const double mass       = facts.driven_inertia / (radius * radius) +
                      pitch_mass * (d.layout.sprockets.back().seats + links / 3.);
  double flexibility = links / d.stiffness_per_pitch;
  for (unsigned int i = 0; i < d.sprockets.size(); ++i)
    flexibility += wrap_flexibility(d,
                                    p.model.capabilities().has_clearances,
                                    d.sprockets[i],
                                    d.layout.sprockets[i].seats,
                                    facts.span(true).tension - facts.centrifugal_tension,
                                    facts.span(false).tension - facts.centrifugal_tension);
  return std::sqrt(1. / (flexibility * mass)) / (2. * PI);
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

std::string mode_in_words(const Facts::Span &span)
{
  return span.symmetric ? "as a string" : "as a chain that sags, in two half waves";
}

const Facts::Span &Facts::span(const bool tight) const
{
  return *std::find_if(
      spans.begin(), spans.end(), [tight](const Span &span) { return span.tight == tight; });
}

Facts make_facts(const Parameters &p, const Drive &d)
{
  Facts facts;
  set_geometry(facts, p, d);
  const double z1 = facts.sprockets[0].teeth, z2 = facts.sprockets[1].teeth;
  const double torque       = facts.sprockets[1].torque;
  facts.power               = torque * facts.sprockets[1].speed;
  facts.tooth_frequency     = z1 * facts.sprockets[0].speed / (2. * PI);
  facts.pitch_time          = facts.tooth_frequency > 0. ? 1. / facts.tooth_frequency : 0.;
  facts.chain_speed         = facts.loaded_pitch * facts.tooth_frequency;
  facts.effective_tension   = 2. * PI * torque / (z2 * facts.loaded_pitch);
  facts.centrifugal_tension = facts.mass_per_metre * facts.chain_speed * facts.chain_speed;

  const double kept            = kept_tension(facts, p, d, facts.effective_tension);
  facts.slack_tension_unloaded = kept_tension(facts, p, d, 0.);
  const double tight           = facts.effective_tension + kept;
  for (Facts::Span &span : facts.spans)
    {
      const double pull      = span.tight ? tight : kept;
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
  const double tension = facts.span(true).tension;
  facts.joint_pressure = tension / facts.bearing_area;
  facts.safety         = tension > 0. ? facts.tensile_strength / tension : 0.;
  // the spans include the angle by which either wrap differs from half a turn
  const double between = facts.sprockets[1].wrap - PI;
  facts.shaft_load = std::sqrt(tight * tight + kept * kept + 2. * tight * kept * std::cos(between));
  facts.driven_inertia  = p.model.driven_inertia.value_or(d.with(Role::driven).solid.inertia[2][2]);
  facts.start_tension   = start_tension(facts, p, d);
  facts.full_speed_from = functions::last_breakpoint(*d.programs.speed, p.time.start);
  facts.driven_frequency = driven_frequency(facts, p, d);
  facts.driven_resonance = 2. * PI * facts.driven_frequency / z1;
  set_limits(facts);
  return facts;
}

unsigned int pitches_per_resonance(const Facts &facts)
{
  const double pitches = facts.tooth_frequency / facts.driven_frequency;
  return pitches > 1. && pitches < 1e6 ? static_cast<unsigned int>(std::ceil(pitches)) : 1;
}

files::Json to_json(const Facts &facts)
{
  files::Json json;
  json["chain"]            = facts.chain;
  json["links"]            = facts.links;
  json["pitch"]            = facts.pitch;
  json["loaded_pitch"]     = facts.loaded_pitch;
  json["mass_per_metre"]   = facts.mass_per_metre;
  json["tensile_strength"] = nullptr;
  json["safety"]           = nullptr;
  if (facts.tensile_strength > 0.)
    {
      json["tensile_strength"] = facts.tensile_strength;
      json["safety"]           = facts.safety;
    }
  json["bearing_area"]    = facts.bearing_area;
  json["ratio"]           = facts.ratio;
  json["centre_distance"] = facts.centre_distance;
  for (const Facts::Sprocket &sprocket : facts.sprockets)
    json["sprockets"].push_back({{"name", sprocket.name},
                                 {"teeth", sprocket.teeth},
                                 {"pitch_diameter", sprocket.pitch_diameter},
                                 {"wrap", sprocket.wrap},
                                 {"speed", sprocket.speed},
                                 {"torque", sprocket.torque},
                                 {"polygon_effect", sprocket.polygon_effect},
                                 {"seating_velocity", sprocket.seating_velocity}});
  for (const Facts::Span &span : facts.spans)
    json["spans"].push_back({{"name", span.tight ? "tight" : "slack"},
                             {"links", span.links},
                             {"length", span.length},
                             {"slack", span.slack},
                             {"sag", span.sag},
                             {"tension", span.tension},
                             {"frequency", span.frequency},
                             {"mode", span.symmetric ? "symmetric" : "antisymmetric"},
                             {"resonance", span.resonance}});
  json["power"]               = facts.power;
  json["chain_speed"]         = facts.chain_speed;
  json["tooth_frequency"]     = facts.tooth_frequency;
  json["pitch_time"]          = facts.pitch_time;
  json["effective_tension"]   = facts.effective_tension;
  json["centrifugal_tension"] = facts.centrifugal_tension;
  json["start_tension"]       = facts.start_tension;
  json["joint_pressure"]      = facts.joint_pressure;
  json["shaft_load"]          = facts.shaft_load;
  json["driven_inertia"]      = facts.driven_inertia;
  json["driven_frequency"]    = facts.driven_frequency;
  json["driven_resonance"]    = facts.driven_resonance;
  json["rated_power"]         = facts.rated_power;
  json["highest_speed"]       = facts.highest_speed;
  return json;
}

std::vector<files::Described> described_facts()
{
  return {
      {"drive/chain", "", "designation of the chain"},
      {"drive/links", "1", "number of links"},
      {"drive/pitch", "m", "nominal pitch"},
      {"drive/loaded_pitch", "m", "mean distance of rollers under load"},
      {"drive/mass_per_metre", "kg/m", "mass of the chain"},
      {"drive/tensile_strength", "N", "least breaking load of the chain's size"},
      {"drive/safety", "1", "tensile strength over the tension of the tight span"},
      {"drive/bearing_area", "m2", "pin diameter times length of the bush"},
      {"drive/ratio", "1", "teeth of the driven sprocket over those of the driver"},
      {"drive/centre_distance", "m", "distance of the shafts"},
      {"drive/sprockets/*/name", "", "driver or driven"},
      {"drive/sprockets/*/teeth", "1", "number of teeth"},
      {"drive/sprockets/*/pitch_diameter", "m", "pitch diameter"},
      {"drive/sprockets/*/wrap", "rad", "wrap of the chain around it"},
      {"drive/sprockets/*/speed", "rad/s", "mean speed"},
      {"drive/sprockets/*/torque", "N m", "mean torque without losses"},
      {"drive/sprockets/*/polygon_effect", "1", "rise and fall of the chain's speed over it"},
      {"drive/sprockets/*/seating_velocity", "m/s", "speed with which a link meets it"},
      {"drive/spans/*/name", "", "tight or slack"},
      {"drive/spans/*/links", "1", "links between the points where it leaves the pitch circles"},
      {"drive/spans/*/length", "m", "length between these points"},
      {"drive/spans/*/slack", "m", "length less the distance of its ends"},
      {"drive/spans/*/sag", "m", "sag in its middle"},
      {"drive/spans/*/tension", "N", "mean tension with the centrifugal one"},
      {"drive/spans/*/frequency", "Hz", "lowest frequency in the plane"},
      {"drive/spans/*/mode", "", "symmetric or antisymmetric"},
      {"drive/spans/*/resonance", "rad/s", "driver speed at which the teeth meet this frequency"},
      {"drive/power", "W", "power of the load"},
      {"drive/chain_speed", "m/s", "mean speed of the chain"},
      {"drive/tooth_frequency", "Hz", "teeth that meet the chain in a second"},
      {"drive/pitch_time", "s", "time from one tooth to the next"},
      {"drive/effective_tension", "N", "power over chain speed"},
      {"drive/centrifugal_tension", "N", "tension that loads neither teeth nor shafts"},
      {"drive/start_tension", "N", "tension of the tight span while the speed grows"},
      {"drive/joint_pressure", "Pa", "tension of the tight span over the bearing area"},
      {"drive/shaft_load", "N", "resultant of both spans on either shaft"},
      {"drive/driven_inertia", "kg m2", "inertia of all that turns with the driven sprocket"},
      {"drive/driven_frequency", "Hz", "frequency of that on the tight span"},
      {"drive/driven_resonance", "rad/s", "driver speed at which the teeth meet this frequency"},
      {"drive/rated_power", "W", "usual limit for this size, teeth and speed"},
      {"drive/highest_speed", "rad/s", "usual limit of the driver's speed"}};
}

void print(std::ostream &out, const Facts &facts)
{
  const auto rpm  = [](const double speed) { return to_text(speed * 30. / PI, 5) + " rpm"; };
  const auto mm   = [](const double length) { return to_text(length * 1e3, 6) + " mm"; };
  const auto line = [&out](const std::string &name, const std::string &text) {
    out << "  " << std::left << std::setw(18) << name << std::right << text << '\n';
  };
  out << "Drive\n";
  line("chain",
       facts.chain + ", " + std::to_string(facts.links) + " links of " + mm(facts.pitch) +
           " pitch (" + mm(facts.loaded_pitch) + " under load), " +
           to_text(facts.mass_per_metre, 4) + " kg/m" +
           (facts.tensile_strength > 0. ?
                ", breaks at " + to_text(facts.tensile_strength * 1e-3, 4) + " kN or more" :
            facts.own_dimensions ? ", strength unknown with dimensions of its own" :
                                   ", strength not listed"));
  for (const Facts::Sprocket &s : facts.sprockets)
    line(s.name,
         std::to_string(s.teeth) + " teeth, pitch diameter " + mm(s.pitch_diameter) + ", wrap " +
             to_text(s.wrap * 180. / PI, 4) + " deg, " + rpm(s.speed) + ", " +
             to_text(s.torque, 4) + " N m, polygon effect " + to_text(100. * s.polygon_effect, 3) +
             " %, links seat at " + to_text(s.seating_velocity, 3) + " m/s");
  line("centre distance",
       mm(facts.centre_distance) + ", " + to_text(facts.centre_distance / facts.pitch, 4) +
           " pitches; ratio " + to_text(facts.ratio, 4));
  line("running",
       to_text(facts.power * 1e-3, 4) + " kW, chain at " + to_text(facts.chain_speed, 4) +
           " m/s, tooth frequency " + to_text(facts.tooth_frequency, 5) + " Hz, a pitch every " +
           to_text(facts.pitch_time * 1e3, 4) + " ms");
  for (const Facts::Span &s : facts.spans)
    line(s.tight ? "tight span" : "slack span",
         std::to_string(s.links) + " links over " + mm(s.length) + ", slack " +
             to_text(s.slack * 1e3, 3) + " mm, sag " + to_text(s.sag * 1e3, 3) + " mm, tension " +
             to_text(s.tension, 4) + " N, " + mode_in_words(s) + " " + to_text(s.frequency, 3) +
             " Hz (tooth frequency at " + rpm(s.resonance) + ")");
  line("tension",
       "effective " + to_text(facts.effective_tension, 4) + " N, centrifugal " +
           to_text(facts.centrifugal_tension, 3) + " N" +
           (facts.start_tension > 0. ?
                ", while the speed grows " + to_text(facts.start_tension, 4) + " N" :
                "") +
           (facts.safety > 0. ? "; safety against breaking " + to_text(facts.safety, 3) : ""));
  line("loads",
       "joint pressure " + to_text(facts.joint_pressure * 1e-6, 3) + " MPa, on each shaft " +
           to_text(facts.shaft_load, 4) + " N");
  line("driven inertia",
       to_text(facts.driven_inertia, 4) + " kg m2, on the tight span " +
           to_text(facts.driven_frequency, 4) + " Hz (tooth frequency at " +
           rpm(facts.driven_resonance) + ")");
  line("usual limits",
       to_text(facts.rated_power * 1e-3, 3) + " kW at this speed; driver up to " +
           rpm(facts.highest_speed));
}
} // namespace chaindrive::drive
