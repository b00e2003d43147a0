// SPDX-License-Identifier: LGPL-2.1-or-later

// The key figures of a drive before it runs: strings and parabolas against each other and against
// integration, the drive of the paper against figures computed by hand; and every check of a
// design, which is silent on one side of its limit and fires on the other.

#include "compare.h"

#include <chaindrive/drive/checks.h>
#include <chaindrive/drive/hanging_span.h>

#include <cmath>
#include <optional>
#include <utility>

using namespace chaindrive;

namespace
{
drive::Facts facts_of(const Parameters &p) { return make_facts(p, drive::make_drive(p)); }

/// Length of a parabola of this chord and sag, by Simpson's rule.
double parabola_length(const double chord, const double sag)
{
  const int n   = 1000;
  double    sum = 0.;
  for (int i = 0; i <= n; ++i)
    {
      const double slope = 4. * sag / chord * (1. - 2. * i / n);
      sum += (i == 0 || i == n ? 1. : (i % 2 == 1 ? 4. : 2.)) * std::sqrt(1. + slope * slope);
    }
  return sum * chord / (3. * n);
}

bool fires(const std::string &name, const Parameters &p)
{
  for (const drive::Check &check : drive::check_design(p, facts_of(p)))
    if (check.name == name)
      {
        std::cout << "  " << check.sentence << '\n';
        return true;
      }
  return false;
}

/// A drive of which no check warns.
Parameters sound_drive()
{
  Parameters p;
  p.time.end = 60e-3;
  return p;
}

template <typename Change>
void test_check(const std::string &name,
                const Change      &change,
                const double       silent,
                const double       loud)
{
  Parameters below = sound_drive(), above = sound_drive();
  change(below, silent);
  change(above, loud);
  const bool is_silent = !fires(name, below), is_loud = fires(name, above);
  verdict(name + " silent at " + std::to_string(silent) + ", fires at " + std::to_string(loud),
          is_silent && is_loud);
}
} // namespace

int main()
{
  std::cout << "== strings and parabolas\n";
  compare("handbook's tight span, Hz",
          drive::string_frequency(0.63968, 0.872, 1431.8, 4.5759),
          31.27,
          2);
  compare("standing string, Hz", drive::string_frequency(0.5, 0.25, 100., 0.), 20., 9);
  const double speed = drive::string_resonance(0.64, 0.87, 1400., 0.015875);
  compare("at its resonance the string has the tooth frequency, ratio",
          drive::string_frequency(0.64, 0.87, 1400. + 0.87 * speed * speed, speed) * 0.015875 /
              speed,
          1.,
          9);
  for (const double sag : {0.02, 0.01}) // of the chord; the error falls with its square
    {
      const double slack = parabola_length(1., sag) - 1.;
      std::cout << "sag " << sag << ": " << drive::parabola_sag(1., slack) / sag << ", tension "
                << drive::HangingSpan{1., 10., 1e-12}.tension(slack) * sag * 8. / 10. << '\n';
    }

  std::cout << "== hanging spans that stretch\n";
  for (const double stretch : {1e-5, 1e-3}) // by the tension; the rest of the parabola is slack
    {
      const double             sag = 0.01, tension = 10. / (8. * sag);
      const drive::HangingSpan span{1., 10., stretch / tension};
      compare("tension over that of the sag",
              span.tension(parabola_length(1., sag) - 1. - stretch) / tension,
              1.,
              3);
    }
  const drive::HangingSpan taut{0.6, 10., 3e-7};
  compare("without slack the tension falls with the cube root of the flexibility",
          drive::HangingSpan{0.6, 10., 8. * 3e-7}.tension(0.) / taut.tension(0.),
          0.5,
          9);
  compare("a weightless chain that is too short is pulled to its place, N",
          drive::HangingSpan{0.6, 0., 3e-7}.tension(-3e-6),
          10.,
          9);
  compare(
      "a weightless chain with slack, N", drive::HangingSpan{0.6, 0., 3e-7}.tension(1e-3), 0., 9);
  const auto mode = [](const double lambda) { // squared
    return drive::lowest_mode({1., 1., 1. / lambda}, 1.);
  };
  const double small = 1e-3, pi = std::acos(-1.);
  compare("growth of the first mode with a little sag, over Rayleigh's 8 lambda^2 / pi^4",
          (std::pow(mode(small).factor, 2) - 1.) * std::pow(pi, 4) / (8. * small),
          1.,
          4);
  compare("modes meet where lambda is 2 pi", mode(4. * pi * pi * (1. - 1e-9)).factor, 2., 6);
  verdict("symmetric before, antisymmetric after",
          mode(0.99 * 4. * pi * pi).symmetric && !mode(1.01 * 4. * pi * pi).symmetric &&
              mode(0.).factor == 1. && mode(1e9).factor == 2.);

  std::cout << "== the paper's drive\n";
  const drive::Facts f = facts_of(Parameters());
  compare("chain speed, m/s", f.chain_speed, 4.5759, 4);
  compare("tooth frequency, Hz", f.tooth_frequency, 288.25, 2);
  compare("power, kW", f.power * 1e-3, 6.468, 3);
  compare("effective tension, N", f.effective_tension, 1413.5, 1);
  compare("driver torque, N m", f.sprockets[0].torque, 53.571, 3);
  compare("polygon effect, %", 100. * f.sprockets[0].polygon_effect, 2.185, 3);
  compare("seating velocity, m/s", f.sprockets[0].seating_velocity, 1.9167, 4);
  compare("wrap, deg", f.sprockets[0].wrap * 180. / M_PI, 167.857, 1);
  compare(
      "wraps together, deg", (f.sprockets[0].wrap + f.sprockets[1].wrap) * 180. / M_PI, 360., 9);
  compare("links in all", f.tight().links + f.slack().links + 6. + 22., f.links, 0);
  compare("sag, mm",
          f.slack().sag * 1e3,
          drive::parabola_sag(f.slack().length, f.slack().slack) * 1e3,
          0);
  compare("torque on the driven shaft from its pull, N m",
          f.effective_tension * f.loaded_pitch * 42. / (2. * M_PI),
          150.,
          9);
  verdict("no check warns of the sound drive",
          drive::check_design(sound_drive(), facts_of(sound_drive())).empty());

  std::cout << "== checks\n";
  const auto torque = [](Parameters &p, const double x) { p.loads.resisting_torque = x; };
  test_check("strength", torque, 390., 5000.);
  test_check("strength", torque, 390., 420.);
  test_check("joint_pressure", torque, 220., 235.);
  test_check("power", torque, 180., 187.);
  const auto ovals = [](Parameters &p, const double x) {
    p.effects.oval_rollers   = parameters::Switch::on;
    p.loads.resisting_torque = x;
  };
  test_check("oval_rollers", ovals, 205., 225.);
  test_check(
      "speed", [](Parameters &p, const double x) { p.loads.driver_speed = x; }, 560., 575.);
  test_check(
      "wrap",
      [](Parameters &p, const double x) {
        p.drive.sprockets.driven().teeth = 90;
        p.drive.n_links                  = static_cast<unsigned int>(x);
      },
      110.,
      104.);
  test_check(
      "teeth",
      [](Parameters &p, const double x) {
        p.drive.sprockets.driver().teeth = static_cast<unsigned int>(x);
      },
      13.,
      12.);
  const double w = f.driven_resonance;
  test_check(
      "driven_resonance",
      [](Parameters &p, const double x) { p.loads.driver_speed = x; },
      1.15 * w,
      1.02 * w);
  const double tight = f.tight().resonance;
  test_check(
      "span_resonance",
      [](Parameters &p, const double x) { p.loads.driver_speed = x; },
      1.3 * tight,
      tight);
  // the sagging span does not swing as a string of its tension would: in two half waves
  const drive::Facts::Span &slack = f.slack();
  std::cout << "slack span " << mode_in_words(slack) << '\n';
  const double string = slack.resonance *
                        drive::string_resonance(slack.length, 1., 1., f.loaded_pitch) /
                        drive::string_resonance(0.5 * slack.length, 1., 1., f.loaded_pitch);
  test_check(
      "span_resonance",
      [](Parameters &p, const double x) { p.loads.driver_speed = x; },
      string,
      slack.resonance);
  const auto wear = [](Parameters &p, const double x) {
    p.drive.chain.elongation = x;
    p.drive.layout.slack     = 5e-3;
  };
  test_check("wear", wear, 0.0295, 0.0305);
  test_check(
      "wear",
      [&](Parameters &p, const double x) {
        wear(p, x);
        p.drive.layout.worn_chain = parameters::WornChain::shafts_kept;
      },
      0.0145,
      0.0155);
  test_check(
      "wear",
      [&](Parameters &p, const double x) {
        wear(p, 0.0175);
        p.drive.sprockets.driven().teeth = static_cast<unsigned int>(x);
        p.drive.n_links                  = 190;
      },
      112.,
      116.);
  test_check(
      "sag",
      [](Parameters &p, const double x) {
        p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::sag;
        p.drive.layout.sag                  = x;
      },
      0.09,
      0.11);
  std::cout << "== a chain with dimensions of its own\n";
  Parameters worn = sound_drive();
  wear(worn, 0.02);
  verdict("wear does not widen sprockets",
          facts_of(worn).sprockets[1].pitch_diameter == f.sprockets[1].pitch_diameter);
  verdict("nor weaken plates", facts_of(worn).tensile_strength == f.tensile_strength);
  for (const auto &[name, member] :
       {std::pair<const char *, std::optional<double> parameters::Chain::*>{
            "inner plates", &parameters::Chain::inner_plate_thickness},
        {"outer plates", &parameters::Chain::outer_plate_height},
        {"pins", &parameters::Chain::pin_diameter},
        {"rollers", &parameters::Chain::roller_diameter}})
    {
      Parameters   p        = sound_drive();
      const double of_table = 1e-3 * (std::string(name) == "inner plates" ? 2. :
                                      std::string(name) == "outer plates" ? 13.02 :
                                      std::string(name) == "pins"         ? 5.24 :
                                                                            10.16);
      p.drive.chain.*member = of_table;
      const double same     = facts_of(p).tensile_strength;
      p.drive.chain.*member = 0.98 * of_table;
      verdict(std::string("other ") + name + ": strength unknown, the same: known",
              facts_of(p).tensile_strength == 0. && same == f.tensile_strength);
    }
  std::cout << "== masses of solids and of catalogues\n";
  for (const auto &[name, from] : {std::pair{"06B", parameters::MassFrom::dimensions},
                                   {"08B", parameters::MassFrom::dimensions},
                                   {"06B", parameters::MassFrom::catalogue}})
    {
      Parameters p;
      p.drive.chain.designation = name;
      p.model.mass_from         = from;
      for (const std::string &note : drive::make_drive(p).notes)
        if (note.find("catalogues") != std::string::npos)
          std::cout << "  " << name << ": " << note << '\n';
      p.drive.chain.outer_plate_thickness = 3e-3;
      for (const std::string &note : drive::make_drive(p).notes)
        if (note.find("catalogues") != std::string::npos)
          std::cout << "NOT SILENT with plates of its own\n";
    }
  std::cout << "== no slack\n";
  for (const auto from : {parameters::CentreDistanceFrom::slack,
                          parameters::CentreDistanceFrom::sag,
                          parameters::CentreDistanceFrom::pretension})
    {
      Parameters p                        = sound_drive();
      p.drive.layout.centre_distance_from = from;
      p.drive.layout.slack = p.drive.layout.sag = p.drive.layout.pretension = 0.;
      if (from != parameters::CentreDistanceFrom::pretension)
        p.drive.layout.start = parameters::Start::settled;
      const drive::Facts none = facts_of(p);
      verdict(text_of(from) + " 0: tension of the slack span below a tenth of the load's",
              none.slack().tension < 0.1 * none.effective_tension + none.centrifugal_tension &&
                  none.slack().tension > none.centrifugal_tension);
      verdict("  its stretch keeps the design sound", drive::check_design(p, none).empty());
    }
  test_check(
      "start", [](Parameters &p, const double x) { p.loads.ramp_time = x; }, 5e-3, 2e-3);
  test_check(
      "window", [](Parameters &p, const double x) { p.time.end = x; }, 50e-3, 40e-3);
  test_check(
      "window", [](Parameters &p, const double x) { p.model.driven_inertia = x; }, 0.1, 0.5);
  test_check(
      "start_up", [](Parameters &p, const double x) { p.loads.ramp_time = x; }, 6e-3, 7e-3);

  std::cout << "changes of the block\n";
  drive::Facts changed = facts_of(Parameters());
  changed.driven_frequency *= 2.;
  print_changes(std::cout, facts_of(Parameters()), changed);
  print_changes(std::cout, changed, changed);
}
