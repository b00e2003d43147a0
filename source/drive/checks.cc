// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/checks.h>
#include <chaindrive/drive/life.h>
#include <chaindrive/drive/oval_load.h>
#include <chaindrive/drive/rules_of_thumb.h>
#include <chaindrive/drive/strands.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace chaindrive::drive
{
using dealii::numbers::PI;

namespace
{
// Rules of thumb, as those of rules_of_thumb.h.
constexpr unsigned int least_teeth          = 13;  // above the speed of the next line
constexpr double       slow                 = 1.;  // m/s
constexpr double       resonance_margin     = 0.1; // of the frequency
constexpr double       most_start_tension   = 3.;  // of the tight span's tension
constexpr double       least_window_pitches = 10.;
constexpr double       most_sag             = 0.1; // of the slack span's length
constexpr double       least_window_swings  = 3.;  // periods of the driven inertia's resonance

std::string newton(const double force)
{
  return force < 1e4 ? to_text(force, 4) + " N" : to_text(force * 1e-3, 4) + " kN";
}

std::string rpm(const double speed) { return to_text(speed * 30. / PI, 4) + " rpm"; }
std::string ms(const double time) { return to_text(time * 1e3, 4) + " ms"; }

struct Checks
{
  const Parameters  &p;
  const Facts       &facts;
  std::vector<Check> found;

  void add(const bool is_found, const std::string &name, const std::string &sentence)
  {
    if (is_found)
      found.push_back({name, sentence});
  }

  bool is_given() const
  {
    return p.drive.layout.centre_distance_from == parameters::CentreDistanceFrom::given;
  }

  /// Of one strand per torque of all, 1/m.
  double tension_per_torque() const
  {
    return 2. * PI / (facts.loaded().teeth * facts.loaded_pitch) / facts.strands;
  }

  /// As a piece of advice, the load with which the chain has the usual safety; empty if it has not
  /// without any. @p after is the torque after its step.
  std::string less_load(const double after) const
  {
    const double factor  = tension_per_torque();
    const double now     = facts.effective_tension;
    const double kept    = facts.slack().tension - facts.centrifugal_tension;
    const double all     = facts.tensile_strength / least_safety - facts.centrifugal_tension;
    const auto   at_most = [](const double value) { return to_text_at_most(value, 3); };
    if (after * factor > now)
      {
        const std::string most = at_most((all - kept) / factor);
        return all <= kept ? "" :
                             ", or a Loads/Torque after step in N m from -" + most + " to " + most;
      }
    // less load leaves more tension in the slack span: on a line that is above that curve
    const double added_tension = std::max(0., facts.slack_tension_unloaded - kept);
    const double most          = (all - kept - added_tension) / (1. - added_tension / now) / factor;
    if (all <= kept + added_tension)
      return "";
    const double speed = facts.loaded().speed; // the load may have been given as power
    return ", or a Loads/Resisting torque in N m of at most " + at_most(most) +
           (speed > 0. ? ", which is a Loads/Power in kW of " + at_most(1e-3 * most * speed) : "");
  }

  void strength()
  {
    // the load may become larger at its step
    const double after  = p.loads.torque_step_time ? std::abs(p.loads.torque_after_step) : 0.;
    const double factor = tension_per_torque();
    const double added_tension = std::max(0., after * factor - facts.effective_tension);
    const double tension       = facts.tight().tension + added_tension;
    const double strength      = facts.tensile_strength;
    if (strength <= 0. || tension <= 0.)
      return;
    const std::string figures =
        facts.strands == 1 ?
            "The tight span pulls with " + newton(tension) + ", and the chain " + facts.chain +
                " breaks at " + newton(strength) :
            "Each of " + std::to_string(facts.strands) + " strands of the tight span pulls with " +
                newton(tension) + ", and its share of what the chain " + facts.chain +
                " breaks at is " + newton(strength);
    const std::string advice =
        " Choose a larger chain or larger sprockets" + less_load(after) + ".";
    add(tension >= strength, "strength", figures + ": it would not hold." + advice);
    add(tension < strength && tension * least_safety > strength,
        "strength",
        figures + ": a safety of " + to_text(strength / tension, 3) + ", where at least " +
            to_text(least_safety) + " is usual." + advice);
  }

  void size()
  {
    const double pressure = uneven_share(facts.strands) * facts.joint_pressure;
    add(pressure > usual_pressure,
        "joint_pressure",
        (facts.strands == 1 ? "The joints carry " :
                              "The joints of the strand that pulls most carry ") +
            to_text(pressure * 1e-6, 3) + " MPa, and wear fast above some " +
            to_text(usual_pressure * 1e-6, 3) +
            " MPa: choose a larger chain, or larger sprockets for the same power.");
    add(facts.power > facts.rated_power && facts.power > 0.,
        "power",
        "At " + rpm(facts.driver().speed) + " " + to_text(facts.power * 1e-3, 3) +
            " kW are more than the " + to_text(facts.rated_power * 1e-3, 3) + " kW that " +
            (facts.strands == 1 ? "a chain" :
                                  "such " + std::to_string(facts.strands) + " strands") +
            " of this pitch usually transmit" + (facts.strands == 1 ? "s" : "") +
            " over the smaller sprocket: choose a "
            "larger chain, more teeth or less power.");
    add(facts.driver().speed > facts.highest_speed,
        "speed",
        "The driver turns at " + rpm(facts.driver().speed) +
            ", and joints of this pitch gall above " + rpm(facts.highest_speed) +
            " under this load: choose a smaller pitch or a lower Loads/Driver speed, in rad/s or "
            "rpm.");
  }

  void sprockets()
  {
    for (const Facts::Sprocket &sprocket : facts.sprockets)
      {
        add(!sprocket.idle && sprocket.wrap < least_wrap,
            "wrap",
            "The chain wraps the " + sprocket.title + " by " +
                to_text(sprocket.wrap * 180. / PI, 4) +
                " degrees only, 120 or more are usual: take " +
                (is_given() ? "a larger Drive/Layout/Centre distance in mm with more links" :
                              "more links for a larger centre distance") +
                ", or a smaller ratio.");
        add(sprocket.teeth > 0 && sprocket.teeth < least_teeth && facts.chain_speed > slow,
            "teeth",
            "The " + sprocket.title + " has " + std::to_string(sprocket.teeth) +
                " teeth at a chain speed of " + to_text(facts.chain_speed, 3) +
                " m/s, so that the speed rises and falls by " +
                to_text(100. * sprocket.polygon_effect, 3) + " %: take at least " +
                std::to_string(least_teeth) + " teeth, better 17.");
      }
  }

  void wear()
  {
    const double worn  = p.drive.chain.elongation;
    const bool   kept  = p.drive.layout.worn_chain == parameters::WornChain::shafts_kept;
    unsigned int teeth = 0;
    for (const Facts::Sprocket &sprocket : facts.sprockets)
      teeth = std::max(teeth, sprocket.teeth);
    const double most = most_elongation(teeth, kept);
    add(worn > most,
        "wear",
        "The chain is worn by Drive/Chain/Elongation in percent = " + to_text(100. * worn, 3) +
            ", more than the " + to_text(100. * most, 3) +
            " % at which a chain is replaced on sprockets of up to " + std::to_string(teeth) +
            " teeth" + (kept ? " whose shafts are not moved" : "") +
            ": its rollers ride near or above the tips of the teeth.");
    using parameters::CentreDistanceFrom;
    const CentreDistanceFrom from  = p.drive.layout.centre_distance_from;
    const Facts::Span       &slack = facts.slack();
    add(slack.sag >= most_sag * slack.length,
        "sag",
        "The slack span sags by " + to_text(slack.sag * 1e3, 3) + " mm, " +
            to_text(100. * slack.sag / slack.length, 3) +
            " % of its length, where 1 to 3 % are usual: closed forms are for flat spans, and the "
            "chain may jump teeth. Take " +
            (is_given() ? "fewer links or a larger Drive/Layout/Centre distance in mm." :
             from == CentreDistanceFrom::slack ? "a smaller Drive/Layout/Slack in mm." :
             from == CentreDistanceFrom::sag   ? "a smaller Drive/Layout/Sag in percent." :
                                                 "a larger Drive/Layout/Pretension in N."));
  }

  void resonances()
  {
    const double tooth = facts.tooth_frequency;
    const auto   near  = [tooth](const double f) {
      return f > 0. && tooth > 0. && std::abs(tooth / f - 1.) < resonance_margin;
    };
    const auto sentence = [&](const std::string &what, const double f) {
      return "The tooth frequency of " + to_text(tooth, 4) + " Hz meets " + what + " at " +
             to_text(f, 4) + " Hz: ";
    };
    add(near(facts.driven_frequency),
        "driven_resonance",
        sentence("the driven inertia on the tight span", facts.driven_frequency) +
            "change the speed, the number of teeth or Model/Driven inertia in kg m2.");
    for (const Facts::Span &span : facts.spans)
      add(near(span.frequency),
          "span_resonance",
          sentence("the " + in_words(span) + " " + mode_in_words(span), span.frequency) +
              "change the speed, the centre distance or guide the span.");
  }

  void start()
  {
    const double tension = facts.tight().tension, least = most_start_tension * tension;
    add(facts.start_tension > least && tension > 0.,
        "start",
        "While the speed grows the tight span pulls with " + newton(facts.start_tension) + ", " +
            to_text(facts.start_tension / std::max(tension, 1e-300), 3) +
            " times as much as in operation: choose Loads/Ramp time in ms of at least " +
            to_text_at_least(p.loads.ramp_time * 1e3 *
                                 (facts.start_tension - facts.effective_tension) /
                                 std::max(least - facts.effective_tension, 1e-300),
                             2) +
            ", or Drive/Layout/Start = settled.");
  }

  void ovals()
  {
    if (p.effects.oval_rollers != parameters::Switch::on)
      return;
    const double load = oval_load(p, facts);
    add(load > 1.,
        "oval_rollers",
        "In operation the first tooth presses a roller " + to_text(load, 3) +
            " times as much as an oval between tooth and bush bears without buckling to a side, "
            "which makes ripple out of nothing: choose Effects/Oval rollers = off.");
  }

  void window()
  {
    if (!p.output.window_start || facts.pitch_time == 0.)
      {
        const bool few = facts.pitch_time > 0. && p.output.window_pitches < least_window_pitches;
        add(few,
            "window",
            "The window has " + std::to_string(p.output.window_pitches) +
                " pitches; means and peaks settle over ten or more: choose a larger Output/Window "
                "length in pitches.");
        return;
      }
    const double from    = std::max(*p.output.window_start, p.time.start);
    const double to      = p.output.window_end.value_or(p.time.end);
    const double pitches = (to - from) / facts.pitch_time;
    // what ends the window later
    const auto later = [&](const double time) {
      const double      at  = std::ceil(time * 1e3);
      const std::string run = "Time/End time in ms", window = "Output/Window end in ms";
      return (!p.output.window_end  ? run :
              at > p.time.end * 1e3 ? run + " and " + window :
                                      window) +
             " of at least " + to_text_at_least(at, 4);
    };
    add(pitches < 0.99 * least_window_pitches, // entries are rounded
        "window",
        "The window has " + to_text(pitches, 3) +
            " pitches; means and peaks settle over ten or more: choose " +
            later(from + least_window_pitches * facts.pitch_time) +
            ", or judge several start phases by a study.");
    const double swings = (to - from) * facts.driven_frequency;
    add(swings < 0.99 * least_window_swings && facts.tooth_frequency > facts.driven_frequency,
        "window",
        "The window has " + to_text(swings, 3) +
            " periods of the driven inertia on the tight span, " +
            to_text(facts.driven_frequency, 4) +
            " Hz, whose swings do not cancel in means over so few: choose " +
            later(from + least_window_swings / facts.driven_frequency) +
            ", or Output/Window start in ms = settled.");
    const bool   settled = p.drive.layout.start == parameters::Start::settled;
    const double over    = facts.full_speed_from + facts.pitch_time;
    add(!settled && from < over,
        "start_up",
        "The window begins at " + ms(from) + ", but the start-up is not over before " +
            to_text_at_least(over * 1e3, 4) + " ms" +
            ", a pitch after the ramp: choose a later Output/Window start in ms, or settled.");
  }
};
} // namespace

std::vector<Check> check_design(const Parameters &parameters, const Facts &facts)
{
  Checks checks{parameters, facts, {}};
  checks.strength();
  checks.size();
  checks.sprockets();
  checks.wear();
  checks.resonances();
  checks.start();
  checks.ovals();
  checks.window();
  return std::move(checks.found);
}

files::Json to_json(const std::vector<Check> &checks)
{
  files::Json json = files::Json::array();
  for (const Check &check : checks)
    json.push_back({{"name", check.name}, {"severity", "warning"}, {"sentence", check.sentence}});
  return json;
}
} // namespace chaindrive::drive
