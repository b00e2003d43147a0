// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/groups.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <utility>

// How facts are told: in the plan and the log, in summary.json, in sentences.

namespace chaindrive::drive
{
using dealii::numbers::PI;

namespace
{
std::string text_of_label(const Facts::Label label)
{
  return label == Facts::Label::tight ? "tight" : label == Facts::Label::slack ? "slack" : "";
}

} // namespace

std::string in_words(const Facts::Span &span)
{
  if (span.label != Facts::Label::none)
    return text_of_label(span.label) + " span";
  std::string name = span.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  return "span from " + name;
}

std::string mode_in_words(const Facts::Span &span)
{
  return span.symmetric ? "as a string" : "as a chain that sags, in two half waves";
}

files::Json to_json(const Facts &facts)
{
  files::Json json;
  json["chain"]            = facts.chain;
  json["strands"]          = facts.strands;
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
    {
      json["sprockets"].push_back({{"name", sprocket.name},
                                   {"title", sprocket.title},
                                   {"centre", {sprocket.centre[0], sprocket.centre[1]}},
                                   {"sense", sprocket.sense},
                                   {"arrival", sprocket.arrival},
                                   {"teeth", sprocket.teeth},
                                   {"pitch_diameter", sprocket.pitch_diameter},
                                   {"wrap", sprocket.wrap},
                                   {"speed", sprocket.speed},
                                   {"torque", sprocket.torque},
                                   {"polygon_effect", sprocket.polygon_effect},
                                   {"seating_velocity", sprocket.seating_velocity},
                                   {"inertia", sprocket.inertia},
                                   {"shaft_load", sprocket.load}});
      if (sprocket.coupling_frequency)
        json["sprockets"].back()["coupling_frequency"] = *sprocket.coupling_frequency;
      if (sprocket.bearing_frequency)
        json["sprockets"].back()["bearing_frequency"] = *sprocket.bearing_frequency;
    }
  const auto held_by = [](const Facts::Held &held) {
    return files::Json{{"holder", held.arm ? "arm" : "slide"},
                       {held.arm ? "pivot" : "direction", {held.of[0], held.of[1]}},
                       {"sense", held.sense},
                       {"travel", held.travel}};
  };
  if (facts.tensioner)
    json["sprockets"][facts.tensioned]["held"] = held_by(*facts.tensioner);
  for (const Facts::Guide &guide : facts.guides)
    {
      files::Json points = files::Json::array();
      for (const dealii::Point<2> &p : guide.points)
        points.push_back({p[0], p[1]});
      json["guides"].push_back({{"span", guide.span}, {"points", points}});
      if (guide.held)
        json["guides"].back()["held"] = held_by(*guide.held);
    }
  for (const Facts::Span &span : facts.spans)
    json["spans"].push_back({{"name", span.name},
                             {"label", text_of_label(span.label)},
                             {"begin", {span.begin[0], span.begin[1]}},
                             {"end", {span.end[0], span.end[1]}},
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
  for (const Group &group : groups_of(facts))
    if (std::isfinite(group.value))
      json["groups"][group.name] = group.value;
  return json;
}

std::vector<files::Described> described_facts()
{
  return {
      {"drive/chain", "", "designation of the chain"},
      {"drive/strands", "1", "number of strands, which share equally but for `strands`"},
      {"drive/links", "1", "number of links"},
      {"drive/pitch", "m", "nominal pitch"},
      {"drive/loaded_pitch", "m", "mean distance of rollers under load"},
      {"drive/mass_per_metre", "kg/m", "mass of one strand"},
      {"drive/tensile_strength",
       "N",
       "least breaking load of the chain's size, by the number of strands"},
      {"drive/safety", "1", "tensile strength over the tension of the tight span"},
      {"drive/bearing_area", "m2", "pin diameter times length of the bush"},
      {"drive/ratio", "1", "teeth of the driven sprocket over those of the driver"},
      {"drive/centre_distance", "m", "distance of the shafts"},
      {"drive/sprockets/*/name", "", "its name in histories"},
      {"drive/sprockets/*/title", "", "what sentences call it"},
      {"drive/sprockets/*/centre/*", "m", "x and y of its axis"},
      {"drive/sprockets/*/sense", "1", "of its rotation, 1 is counter-clockwise"},
      {"drive/sprockets/*/arrival", "rad", "polar angle at which the chain arrives"},
      {"drive/sprockets/*/teeth", "1", "number of teeth; 0 of a wheel without teeth"},
      {"drive/sprockets/*/pitch_diameter", "m", "pitch diameter"},
      {"drive/sprockets/*/wrap", "rad", "wrap of the chain around it"},
      {"drive/sprockets/*/speed", "rad/s", "mean speed"},
      {"drive/sprockets/*/torque", "N m", "mean torque without losses"},
      {"drive/sprockets/*/polygon_effect", "1", "rise and fall of the chain's speed over it"},
      {"drive/sprockets/*/seating_velocity", "m/s", "speed with which a link meets it"},
      {"drive/sprockets/*/inertia",
       "kg m2",
       "inertia of all that turns with it, what is behind its coupling included"},
      {"drive/sprockets/*/shaft_load", "N", "resultant of the spans at its two ends on its shaft"},
      {"drive/sprockets/*/coupling_frequency",
       "Hz",
       "of the inertias on both sides of its coupling, if it has one, without the chain"},
      {"drive/sprockets/*/bearing_frequency/*",
       "Hz",
       "of its mass on its bearing, if that yields, along x and y, without the chain"},
      {"drive/sprockets/*/held/holder", "", "arm or slide, of the tensioner that its wheel is"},
      {"drive/sprockets/*/held/pivot/*", "m", "x and y of the arm's pivot"},
      {"drive/sprockets/*/held/direction/*", "1", "x and y of the slide's direction"},
      {"drive/sprockets/*/held/sense", "1", "1: travel turns the arm counter-clockwise"},
      {"drive/sprockets/*/held/travel", "rad or m", "at the start"},
      {"drive/guides/*/span", "", "name of the span beside which it is"},
      {"drive/guides/*/points/*/*", "m", "x and y of points of its line at the start"},
      {"drive/guides/*/held/holder", "", "arm or slide of one that a spring presses"},
      {"drive/guides/*/held/pivot/*", "m", "x and y of the arm's pivot"},
      {"drive/guides/*/held/direction/*", "1", "x and y of the slide's direction"},
      {"drive/guides/*/held/sense", "1", "1: travel turns the arm counter-clockwise"},
      {"drive/guides/*/held/travel", "rad or m", "at the start"},
      {"drive/spans/*/name", "", "of the sprockets at its ends, in the direction of travel"},
      {"drive/spans/*/label", "", "tight or slack, by its tension, or nothing"},
      {"drive/spans/*/begin/*", "m", "x and y of the point where it leaves the first pitch circle"},
      {"drive/spans/*/end/*", "m", "x and y of the point where it meets the second one"},
      {"drive/spans/*/links", "1", "links between the points where it leaves the pitch circles"},
      {"drive/spans/*/length", "m", "length between these points"},
      {"drive/spans/*/slack", "m", "length less the distance of its ends"},
      {"drive/spans/*/sag", "m", "sag in its middle"},
      {"drive/spans/*/tension", "N", "mean tension of one strand with the centrifugal one"},
      {"drive/spans/*/frequency", "Hz", "lowest frequency in the plane"},
      {"drive/spans/*/mode", "", "symmetric or antisymmetric"},
      {"drive/spans/*/resonance", "rad/s", "driver speed at which the teeth meet this frequency"},
      {"drive/power", "W", "power of the load"},
      {"drive/chain_speed", "m/s", "mean speed of the chain"},
      {"drive/tooth_frequency", "Hz", "teeth that meet the chain in a second"},
      {"drive/pitch_time", "s", "time from one tooth to the next"},
      {"drive/effective_tension", "N", "power over chain speed, of one strand"},
      {"drive/centrifugal_tension", "N", "tension that loads neither teeth nor shafts"},
      {"drive/start_tension", "N", "tension of the tight span while the speed grows"},
      {"drive/joint_pressure", "Pa", "tension of the tight span over the bearing area"},
      {"drive/shaft_load", "N", "resultant of both spans on the driven shaft"},
      {"drive/driven_inertia", "kg m2", "inertia of all that turns with the driven sprocket"},
      {"drive/driven_frequency", "Hz", "frequency of that on the tight span"},
      {"drive/driven_resonance", "rad/s", "driver speed at which the teeth meet this frequency"},
      {"drive/rated_power", "W", "usual limit for this size, teeth and speed"},
      {"drive/highest_speed", "rad/s", "usual limit of the driver's speed"},
      {"drive/groups/resonance",
       "1",
       "tooth frequency over driven_frequency; this and the next: by which drives are alike"},
      {"drive/groups/centrifugal", "1", "centrifugal over effective tension"},
      {"drive/groups/impact",
       "1",
       "mass per length times square of the driver's seating velocity over effective tension"},
      {"drive/groups/pressure", "1", "joint pressure over that at which chains break"},
      {"drive/groups/polygon_effect", "1", "polygon effect of the driver"},
      {"drive/groups/sag", "1", "sag of the slack span over the pitch"}};
}

namespace
{
/// What print() says: names of rows and their texts.
using Lines = std::vector<std::pair<std::string, std::string>>;

Lines lines_of(const Facts &facts)
{
  Lines      lines;
  const auto rpm  = [](const double speed) { return to_text(speed * 30. / PI, 5) + " rpm"; };
  const auto mm   = [](const double length) { return to_text(length * 1e3, 6) + " mm"; };
  const auto line = [&lines](const std::string &name, const std::string &text) {
    lines.emplace_back(name, text);
  };
  std::string on_shafts;
  for (const Facts::Sprocket &s : facts.sprockets)
    on_shafts += (on_shafts.empty() ? ", on shafts " : ", ") + to_text(s.load, 4);
  if (facts.sprockets.size() == 2)
    on_shafts = ", on each shaft " + to_text(facts.shaft_load, 4);
  const bool several = facts.strands > 1;
  line("chain",
       (several ? std::to_string(facts.strands) + " strands of " : "") + facts.chain + ", " +
           std::to_string(facts.links) + " links of " + mm(facts.pitch) + " pitch (" +
           mm(facts.loaded_pitch) + " under load), " + to_text(facts.mass_per_metre, 4) +
           (several ? " kg/m each" : " kg/m") +
           (facts.tensile_strength > 0. ?
                (several ? ", break together at " : ", breaks at ") +
                    to_text(facts.strands * facts.tensile_strength * 1e-3, 4) + " kN or more" :
            facts.own_dimensions ? ", strength unknown with dimensions of its own" :
                                   ", strength not listed"));
  for (const Facts::Sprocket &s : facts.sprockets)
    line(s.title,
         (s.teeth > 0 ? std::to_string(s.teeth) + " teeth, pitch" :
                        std::string("no teeth, joints'")) +
             " diameter " + mm(s.pitch_diameter) + ", wrap " + to_text(s.wrap * 180. / PI, 4) +
             " deg, " + rpm(s.speed) + ", " + to_text(s.torque, 4) + " N m, polygon effect " +
             to_text(100. * s.polygon_effect, 3) + " %, links seat at " +
             to_text(s.seating_velocity, 3) + " m/s");
  line("centre distance",
       mm(facts.centre_distance) + ", " + to_text(facts.centre_distance / facts.pitch, 4) +
           " pitches; ratio " + to_text(facts.ratio, 4));
  line("running",
       to_text(facts.power * 1e-3, 4) + " kW, chain at " + to_text(facts.chain_speed, 4) +
           " m/s, tooth frequency " + to_text(facts.tooth_frequency, 5) + " Hz, a pitch every " +
           to_text(facts.pitch_time * 1e3, 4) + " ms");
  for (const Facts::Span &s : facts.spans)
    line(in_words(s),
         std::to_string(s.links) + " links over " + mm(s.length) + ", slack " +
             to_text(s.slack * 1e3, 3) + " mm, sag " + to_text(s.sag * 1e3, 3) + " mm, tension " +
             to_text(s.tension, 4) + " N, " + mode_in_words(s) + " " + to_text(s.frequency, 3) +
             " Hz (tooth frequency at " + rpm(s.resonance) + ")");
  line("tension",
       (several ? "of one strand: effective " : "effective ") +
           to_text(facts.effective_tension, 4) + " N, centrifugal " +
           to_text(facts.centrifugal_tension, 3) + " N" +
           (facts.start_tension > 0. ?
                ", while the speed grows " + to_text(facts.start_tension, 4) + " N" :
                "") +
           (facts.safety > 0. ? "; safety against breaking " + to_text(facts.safety, 3) : ""));
  line("loads",
       "joint pressure " + to_text(facts.joint_pressure * 1e-6, 3) + " MPa" + on_shafts + " N");
  line("driven inertia",
       to_text(facts.driven_inertia, 4) + " kg m2, on the tight span " +
           to_text(facts.driven_frequency, 4) + " Hz (tooth frequency at " +
           rpm(facts.driven_resonance) + ")");
  const auto met_at = [&](const double frequency) {
    return to_text(frequency, 4) + " Hz (tooth frequency at " +
           rpm(2. * dealii::numbers::PI * frequency / facts.driver().teeth) + ")";
  };
  for (const Facts::Sprocket &s : facts.sprockets)
    {
      if (s.coupling_frequency)
        line(s.name + " coupling", "without the chain " + met_at(*s.coupling_frequency));
      if (!s.bearing_frequency)
        continue;
      const auto [x, y] = *s.bearing_frequency;
      line(s.name + " bearing",
           "without the chain " +
               (x == y ? met_at(x) : "along x " + met_at(x) + ", along y " + met_at(y)));
    }
  line("usual limits",
       to_text(facts.rated_power * 1e-3, 3) + " kW at this speed; driver up to " +
           rpm(facts.highest_speed));
  return lines;
}

void print_line(std::ostream &out, const std::pair<std::string, std::string> &line)
{
  out << "  " << std::left << std::setw(18) << line.first + (line.first.size() < 18 ? "" : " ")
      << std::right << line.second << '\n';
}
} // namespace

void print(std::ostream &out, const Facts &facts)
{
  out << "Drive\n";
  for (const auto &line : lines_of(facts))
    print_line(out, line);
}

void print_changes(std::ostream &out, const Facts &before, const Facts &facts)
{
  const Lines old = lines_of(before);
  bool        any = false;
  for (const auto &line : lines_of(facts))
    {
      if (std::find(old.begin(), old.end(), line) != old.end())
        continue;
      out << (any ? "" : "Drive, with its parts solved\n");
      print_line(out, line);
      any = true;
    }
}
} // namespace chaindrive::drive
