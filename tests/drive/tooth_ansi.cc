// SPDX-License-Identifier: LGPL-2.1-or-later

// ANSI/ASME B29.1 tooth form of 15 and 42 teeth: the constants of the standard's construction, read
// off the profile, against values computed by an independent script; mm and deg.

#include "compare.h"

#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/numbers.h>

using namespace chaindrive;

int main()
{
  const double                 degree = dealii::numbers::PI / 180.;
  const drive::ChainDimensions chain  = drive::make_chain(parameters::Chain());
  parameters::Sprockets        sprockets;
  sprockets.tooth_form = parameters::StandardForm::ansi;

  struct Expected
  {
    unsigned int z;
    double       A, B, M, T, W, V, F, H, S, bottom, outside;
  };
  for (const Expected &e : {Expected{15,
                                     39.000,
                                     14.267,
                                     6.3166,
                                     5.1151,
                                     13.9132,
                                     2.9573,
                                     8.4800,
                                     5.6913,
                                     8.9473,
                                     66.0675,
                                     84.2110},
                            Expected{42,
                                     36.429,
                                     16.667,
                                     6.5398,
                                     4.8266,
                                     14.1842,
                                     1.0630,
                                     8.2233,
                                     5.3012,
                                     8.3115,
                                     202.1442,
                                     221.3622}})
    {
      const drive::ToothForm f    = drive::make_tooth_form(e.z, chain, sprockets, 0);
      const drive::Segment  &seat = f.half_profile[0], &work = f.half_profile[1],
                           &straight = f.half_profile[2], &top = f.half_profile[3];
      const double a = seat.centre[0]; // the standard's origin, its y axis along our x, its x to -y
      const double half = dealii::numbers::PI / e.z, p = chain.pitch;
      std::cout << "== " << e.z << " teeth, " << f.half_profile.size() << " segments\n";
      compare("R", seat.radius * 1e3, 5.1435, 4);
      compare("a on the pitch circle", 2e3 * a, f.pitch_diameter * 1e3, 4);
      compare("A", seat.end_angle / degree - 90., e.A, 3);
      compare("B", (work.begin_angle - work.end_angle) / degree, e.B, 3);
      compare("E", work.radius * 1e3, 13.2715, 4);
      compare("M", -work.centre[1] * 1e3, e.M, 4);
      compare("T", (work.centre[0] - a) * 1e3, e.T, 4);
      compare("W", top.centre[1] * 1e3, e.W, 4);
      compare("V", (a - top.centre[0]) * 1e3, e.V, 4);
      compare("F", top.radius * 1e3, e.F, 4);
      // H, S: from the topping arc's centre to where the pitch line meets the arc on the tooth's
      // axis
      const double offset = 1.4 * chain.roller_diameter - 0.5 * p;
      const double H      = std::sqrt(top.radius * top.radius - offset * offset);
      compare("H", H * 1e3, e.H, 4);
      compare("S", (0.5 * p * std::cos(half) + H * std::sin(half)) * 1e3, e.S, 4);
      compare("bottom diameter", f.root_diameter * 1e3, e.bottom, 4);
      compare("outside diameter", f.outside_diameter * 1e3, e.outside, 4);
      // the topping arc's centre is p/2 - 1.4 Dr off the tooth's axis, p/2 cot(pi/z) along it
      compare("pointed diameter", f.pointed_diameter * 1e3, (p / std::tan(half) + 2. * H) * 1e3, 4);
      compare("straight over its formula",
              straight.length() /
                  (chain.roller_diameter * (1.4 * std::sin((17. - 64. / e.z) * degree) -
                                            0.8 * std::sin((18. - 56. / e.z) * degree))),
              1.,
              9);
      verdict("positive tip land", f.tip_land() > 0.);
    }

  std::cout << "== bottom diameter given: the gullet moves as a whole\n";
  sprockets.seat_centre              = parameters::SeatCentre::bottom_diameter;
  sprockets.driver().bottom_diameter = 66.2e-3;
  const drive::ToothForm f           = drive::make_tooth_form(15, chain, sprockets, 0);
  compare("bottom diameter", f.root_diameter * 1e3, 66.2, 4);
  compare("lowest point", 2e3 * f.half_profile.front().begin.norm(), 66.2, 4);
}
