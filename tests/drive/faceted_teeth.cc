// SPDX-License-Identifier: LGPL-2.1-or-later

// Teeth of chords: where their corners are, the path of a roller along a seat of chords in closed
// form, that they never stand out of the smooth teeth, that they tend to these by the square of the
// length of a chord, and that their stiffness curve is that of the bottom of a gap everywhere.

#include "compare.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/drive/stiffness_fit.h>
#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/numbers.h>

using namespace chaindrive;
using dealii::Point;

namespace
{
drive::ToothForm make_form(const parameters::StandardForm standard)
{
  parameters::Sprockets sprockets;
  sprockets.tooth_form = standard;
  return drive::make_tooth_form(15, drive::make_chain(parameters::Chain()), sprockets, 0);
}

/// A roller of radius R in the seat, radius r, half angle A, of m chords of the angle a = 2 A / m.
/// With its centre at the distance r - R from the seat's, it is nearest to the chord whose middle
/// is at the angle b from the bottom, and its gap, which is zero in a smooth seat, is (r - R)
/// (1 - cos(t - b)) at the angle t: zero at the middle of each chord, most at its ends.
void check_seat(const drive::ToothForm &smooth, const unsigned int n, const unsigned int chords)
{
  const drive::ToothForm f = smooth.faceted(n);
  const Point<2>         seat(0.5 * f.root_diameter + f.seat_radius, 0.);
  const double           a = f.seat_half_angle / chords, R = 0.5 * f.roller_diameter;
  const double           off = f.seat_radius - R;
  std::cout << "== " << n << " chords\n";
  std::cout << "in a half profile: " << f.half_profile.size() << '\n';

  double corner = 0.;
  for (unsigned int i = 0; i <= chords; ++i)
    {
      const Point<2> &p     = i == 0 ? f.half_profile[0].begin : f.half_profile[i - 1].end;
      const double    angle = dealii::numbers::PI - i * a;
      const Point<2>  exact(seat + f.seat_radius / std::cos(0.5 * a) *
                                      Point<2>(std::cos(angle), std::sin(angle)));
      corner = std::max(corner, p.distance(exact));
    }
  verdict("corners of the seat at r / cos(a/2), a apart, to 1e-12 mm", corner < 1e-15);

  double worst = 0.;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const double t = (i + 0.5) / 1000. * f.seat_half_angle;
      const double b = (std::floor(t / a) + 0.5) * a;
      const double gap =
          f.closest_point(seat + off * Point<2>(-std::cos(t), std::sin(t))).distance - R;
      worst = std::max(worst, std::abs(gap - off * (1. - std::cos(t - b))));
    }
  verdict("gap of a roller along the seat as in closed form, to 1e-12 mm", worst < 1e-15);
}

/// Root of the mean square of the distances of 4000 points of the smooth profile from the faceted
/// one, m; @p least: the smallest, of which a negative one were metal outside of the smooth tooth.
double deviation(const drive::ToothForm &smooth, const unsigned int n, double &least)
{
  const drive::ToothForm f      = smooth.faceted(n);
  const auto             line   = smooth.half_polyline(1000);
  double                 square = 0.;
  for (const Point<2> &p : line)
    {
      const double d = f.closest_point(p).distance;
      square += d * d / line.size();
      least = std::min(least, d);
    }
  return std::sqrt(square);
}

void check_order(const parameters::StandardForm standard)
{
  const drive::ToothForm smooth = make_form(standard);
  std::cout << "== " << text_of(standard) << '\n';
  double       least  = 0.;
  const double coarse = deviation(smooth, 96, least), fine = deviation(smooth, 768, least);
  compare("order of the deviation from 96 to 768 chords", std::log2(coarse / fine) / 3., 2., 1);
  verdict("nowhere outside of the smooth tooth, to 1e-12 mm", least > -1e-15);
}
/// On teeth of so many chords, which are half as stiff at the end of the seat: what a roller bears
/// there over what it bears at the bottom of a gap.
double softer_end(const unsigned int chords)
{
  Parameters p;
  p.model.fidelity         = "layered";
  p.drive.sprockets.facets = chords;
  p.loads.resisting_torque = 150.;
  const drive::Drive drive = drive::make_drive(p, [](const drive::Drive &d, const double load) {
    drive::PartStiffness parts = drive::estimated_stiffness(d.chain, load, {210e9, 0.3, 7600.});
    parts.curves.roller_tooth  = {
         drive::StiffnessCurve{{4e8, -4e8, 0.}, {6e8, -6e8, 0.}, 2e-6, 0.03, 5e-3, 0.5}};
    return parts;
  });
  const drive::StiffnessCurve &curve = *drive.curves.roller_tooth.front();
  return drive::force_of(curve, 0.5, 1e-6) / drive::force_of(curve, 0., 1e-6);
}
} // namespace

int main()
{
  compare("arcs at the end of the seat over the bottom", softer_end(0), 0.5, 6);
  compare("chords", softer_end(16), 1., 6);
  const drive::ToothForm smooth = make_form(parameters::StandardForm::iso_min);
  check_seat(smooth, 16, 4);
  check_seat(smooth, 48, 11);
  for (const auto standard : {parameters::StandardForm::iso_min,
                              parameters::StandardForm::iso_max,
                              parameters::StandardForm::ansi})
    check_order(standard);
}
