// SPDX-License-Identifier: LGPL-2.1-or-later

// ISO 606 gap forms of 15 and 42 teeth against coordinates computed by an independent script, and
// what must hold for any form: tangency, no step between segments, clearance of a seated roller.

#include "compare.h"

#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/numbers.h>

#include <array>

using namespace chaindrive;
using parameters::SeatCentre;
using parameters::StandardForm;

namespace
{
constexpr double degree = dealii::numbers::PI / 180.;

parameters::Sprockets sprockets(const StandardForm form, const SeatCentre centre)
{
  parameters::Sprockets s;
  s.tooth_form                = form;
  s.seat_centre               = centre;
  s.driver().outside_diameter = 81.8e-3;
  s.driven().outside_diameter = 219.0e-3;
  s.driver().bottom_diameter  = 66.28e-3;
  s.driven().bottom_diameter  = 202.82e-3;
  return s;
}

struct Expected
{
  unsigned int          teeth;
  SeatCentre            centre;
  double                seat_centre, bottom;
  std::array<double, 6> points; // S, C, T
  double                sweep, gamma, land, pointed, area, phi;
};

void check_values(const drive::ChainDimensions &chain, const Expected &e)
{
  const drive::ToothForm f = drive::make_tooth_form(
      e.teeth, chain, sprockets(StandardForm::iso_min, e.centre), e.teeth == 15 ? 0 : 1);
  const drive::Segment &seat = f.half_profile[0], &flank = f.half_profile[1];
  std::cout << "== " << e.teeth << " teeth, seat centre " << text_of(e.centre)
            << ", mm, deg, mm2\n";
  compare("seat centre", seat.centre[0] * 1e3, e.seat_centre, 5);
  compare("bottom diameter", f.root_diameter * 1e3, e.bottom, 4);
  compare("S x", seat.end[0] * 1e3, e.points[0], 5);
  compare("S y", seat.end[1] * 1e3, e.points[1], 5);
  compare("C x", flank.centre[0] * 1e3, e.points[2], 5);
  compare("C y", flank.centre[1] * 1e3, e.points[3], 5);
  compare("T x", flank.end[0] * 1e3, e.points[4], 5);
  compare("T y", flank.end[1] * 1e3, e.points[5], 5);
  compare("flank sweep", (flank.end_angle - flank.begin_angle) / degree, e.sweep, 5);
  compare("tip angle", f.half_profile[2].begin_angle / degree, e.gamma, 5);
  compare("tip land", f.tip_land() * 1e3, e.land, 4);
  compare("pointed diameter", f.pointed_diameter * 1e3, e.pointed, 4);
  compare("area", f.area() * 1e6, e.area, 4);
  compare("pressure angle at seat end", f.seat_end_pressure_angle() / degree, e.phi, 3);
}

/// Every joint but the tip's edge is smooth, every segment begins where the last one ended.
void check_smooth(const std::string &name, const drive::ToothForm &f)
{
  double step = 0., kink = 0.;
  for (std::size_t i = 0; i + 1 < f.half_profile.size(); ++i)
    {
      const drive::Segment &a = f.half_profile[i], &b = f.half_profile[i + 1];
      step = std::max(step, a.end.distance(b.begin));
      if (i + 2 == f.half_profile.size())
        continue;
      const auto before = a.end - a.point(1. - 1e-7), after = b.point(1e-7) - b.begin;
      kink = std::max(
          kink,
          std::abs((before[0] * after[1] - before[1] * after[0]) / (before.norm() * after.norm())));
    }
  const dealii::Point<2> seated(0.5 * (f.root_diameter + f.roller_diameter), 0.);
  const double           clearance = f.closest_point(seated).distance - 0.5 * f.roller_diameter;
  verdict(name + ": no step (1e-12 mm), no kink (1e-6), seated roller touches the bottom only",
          step < 1e-15 && kink < 1e-6 && std::abs(clearance) < 1e-15);
}
} // namespace

int main()
{
  const drive::ChainDimensions chain = drive::make_chain(parameters::Chain());

  for (const Expected &e : std::initializer_list<Expected>{{15,
                                                            SeatCentre::iso,
                                                            38.22806636140654,
                                                            66.19453272281308,
                                                            {{36.22330308735378,
                                                              4.722926302093781,
                                                              28.12485342583369,
                                                              23.801678096690445,
                                                              40.292557961158074,
                                                              7.022803781020565}},
                                                            12.948872330578205,
                                                            9.887064689281416,
                                                            3.016594064791737,
                                                            87.33538467117403,
                                                            4145.5291,
                                                            11.0},
                                                           {15,
                                                            SeatCentre::pitch,
                                                            38.17726636140654,
                                                            66.09293272281307,
                                                            {{36.172503087353775,
                                                              4.722926302093781,
                                                              28.07405342583369,
                                                              23.801678096690445,
                                                              40.28683105382172,
                                                              7.055582445186625}},
                                                            13.102936386458587,
                                                            9.933679066336333,
                                                            2.950043682276709,
                                                            87.2031149429959,
                                                            4134.8014,
                                                            11.0},
                                                           {15,
                                                            SeatCentre::bottom_diameter,
                                                            38.2708,
                                                            66.28,
                                                            {{36.26603672594724,
                                                              4.722926302093781,
                                                              28.167587064427153,
                                                              23.801678096690445,
                                                              40.29733452371015,
                                                              6.995343471495756}},
                                                            12.819364168951621,
                                                            9.848018607186233,
                                                            3.0723393490435487,
                                                            87.4465990141062,
                                                            4154.5148,
                                                            11.0},
                                                           {42,
                                                            SeatCentre::iso,
                                                            106.2663768722596,
                                                            202.2711537445192,
                                                            {{104.42169248973049,
                                                              4.787718472179958,
                                                              85.13469538130732,
                                                              54.84544824071497,
                                                              109.27975333513406,
                                                              6.9415784236913325}},
                                                            5.678113462116298,
                                                            3.634612052012651,
                                                            2.488689226195103,
                                                            224.55137896051417,
                                                            34250.0166,
                                                            16.785714285714278},
                                                           {42,
                                                            SeatCentre::pitch,
                                                            106.2155768722596,
                                                            202.16955374451922,
                                                            {{104.3708924897305,
                                                              4.787718472179958,
                                                              85.08389538130733,
                                                              54.84544824071497,
                                                              109.27817264681106,
                                                              6.966418231326415}},
                                                            5.7369978472523595,
                                                            3.647635749312896,
                                                            2.438909124885854,
                                                            224.43429765172868,
                                                            34220.3425,
                                                            16.785714285714278},
                                                           {42,
                                                            SeatCentre::bottom_diameter,
                                                            106.5408,
                                                            202.82,
                                                            {{104.69611561747088,
                                                              4.787718472179958,
                                                              85.40911850904772,
                                                              54.84544824071497,
                                                              109.28813107283572,
                                                              6.808407053538865}},
                                                            5.360350397805416,
                                                            3.564792494229177,
                                                            2.7555585014632675,
                                                            225.18374220305316,
                                                            34408.4925,
                                                            16.785714285714278}})
    check_values(chain, e);

  std::cout << "== maximum form, seat centre pitch, 15 and 42 teeth\n";
  const parameters::Sprockets most  = sprockets(StandardForm::iso_max, SeatCentre::pitch);
  const auto                  max15 = drive::make_tooth_form(15, chain, most, 0);
  const auto                  max42 = drive::make_tooth_form(42, chain, most, 1);
  compare("seat radius", max15.seat_radius * 1e3, 5.28024, 5);
  compare("flank radius 15", max15.flank_radius * 1e3, 32.9184, 4);
  compare("flank radius 42", max42.flank_radius * 1e3, 158.0083, 4);
  compare("pointed 15", max15.pointed_diameter * 1e3, 82.80, 2);
  compare("pointed 42", max42.pointed_diameter * 1e3, 219.19, 2);
  compare("pressure angle 15", max15.seat_end_pressure_angle() / degree, 21.0, 3);
  compare("pressure angle 42", max42.seat_end_pressure_angle() / degree, 26.786, 3);

  std::cout << "== mid form: means of minimum and maximum form\n";
  const auto min15 =
      drive::make_tooth_form(15, chain, sprockets(StandardForm::iso_min, SeatCentre::iso), 0);
  const auto mid15 =
      drive::make_tooth_form(15, chain, sprockets(StandardForm::iso_mid, SeatCentre::iso), 0);
  compare("seat radius", mid15.seat_radius * 1e3, 0.5 * (5.130800 + 5.280242), 5);
  compare("flank radius", mid15.flank_radius * 1e3, 0.5 * (20.7264 + 32.9184), 4);
  compare("seating angle", 2. * mid15.seat_half_angle / degree, 124., 4);
  compare("minimum form's seating angle", 2. * min15.seat_half_angle / degree, 134., 4);

  std::cout << "== any form\n";
  for (const auto form :
       {StandardForm::iso_min, StandardForm::iso_mid, StandardForm::iso_max, StandardForm::ansi})
    for (const unsigned int z : {9u, 15u, 42u, 120u})
      {
        parameters::Sprockets s;
        s.tooth_form = form;
        check_smooth(text_of(form) + ", " + std::to_string(z) + " teeth",
                     drive::make_tooth_form(z, chain, s, 0));
      }

  std::cout << "== default outside diameters, mm\n";
  parameters::Sprockets automatic;
  const auto            free15 = drive::make_tooth_form(15, chain, automatic, 0);
  compare("midway between 80.3762 and 86.0383", free15.outside_diameter * 1e3, 83.20725, 4);
  automatic.tooth_form = StandardForm::iso_max;
  const auto clipped   = drive::make_tooth_form(15, chain, automatic, 0);
  compare("tip land of the maximum form over the pitch", clipped.tip_land() / chain.pitch, 0.05, 6);

  // ISO 606 allows d + p (1 - 1.6 / z) - d1 to d + 1.25 p - d1
  unsigned int n = 0, n_below = 0, n_silent = 0;
  for (const std::string &name : drive::chain_designations())
    for (const auto form : {StandardForm::iso_min, StandardForm::iso_mid, StandardForm::iso_max})
      for (unsigned int z = 9; z <= 150; z += 3)
        {
          parameters::Chain size;
          size.designation     = name;
          automatic.tooth_form = form;
          const auto   c       = drive::make_chain(size);
          const auto   f       = drive::make_tooth_form(z, c, automatic, 0);
          const double least   = f.pitch_diameter + c.pitch * (1. - 1.6 / z) - c.roller_diameter;
          const bool   below   = f.outside_diameter < least * (1. - 1e-12);
          const bool   said    = f.derived.front().find("below the limits") != std::string::npos;
          ++n;
          n_below += below ? 1 : 0;
          n_silent += below != said ? 1 : 0;
        }
  std::cout << "of " << n << " automatic diameters " << n_below << " are below ISO 606, of which "
            << n_silent << " do not say so\n";
  parameters::Chain eight;
  eight.designation    = "08B";
  automatic.tooth_form = StandardForm::iso_max;
  const auto tight     = drive::make_tooth_form(57, drive::make_chain(eight), automatic, 0);
  compare(
      "08B, 57 teeth, maximum form: the least of ISO 606", tight.outside_diameter * 1e3, 234.37, 2);
  std::cout << tight.derived.front() << '\n';

  std::cout << "== refused\n";
  expect_refusal("8 teeth", [&] { drive::make_tooth_form(8, chain, automatic, 0); });
  expect_refusal("maximum form with 82.9 mm", [&] {
    auto s                      = sprockets(StandardForm::iso_max, SeatCentre::pitch);
    s.driver().outside_diameter = 82.9e-3;
    drive::make_tooth_form(15, chain, s, 0);
  });
  expect_refusal("outside diameter within the seats", [&] {
    auto s                      = sprockets(StandardForm::iso_min, SeatCentre::iso);
    s.driver().outside_diameter = 70e-3;
    drive::make_tooth_form(15, chain, s, 0);
  });
  expect_refusal("no bottom diameter", [&] {
    auto s = sprockets(StandardForm::iso_min, SeatCentre::bottom_diameter);
    s.driven().bottom_diameter.reset();
    drive::make_tooth_form(42, chain, s, 1);
  });
}
