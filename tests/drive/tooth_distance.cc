// SPDX-License-Identifier: LGPL-2.1-or-later

// The nearest point of a profile against a fine polyline of the whole sprocket, for points all
// around: in gaps, within teeth, over tips, far outside; its sign by counting crossings; continuity
// along paths; agreement of normal, point and distance. Faceted teeth are such a polyline.

#include "compare.h"

#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/numbers.h>

#include <random>

using namespace chaindrive;
using dealii::Point;

namespace
{
double distance_to_polyline(const std::vector<Point<2>> &line, const Point<2> &p)
{
  double least  = 1e9;
  bool   inside = false;
  for (std::size_t i = 0; i < line.size(); ++i)
    {
      const Point<2> &a = line[i], &b = line[(i + 1) % line.size()];
      const auto      d = b - a;
      const double    t = std::max(0., std::min(1., ((p - a) * d) / d.norm_square()));
      least             = std::min(least, (p - (a + t * d)).norm());
      if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / d[1] * d[0])
        inside = !inside;
    }
  return inside ? -least : least;
}

void check(const parameters::StandardForm form,
           const unsigned int             z,
           const drive::ChainDimensions  &chain,
           const unsigned int             facets = 0)
{
  parameters::Sprockets sprockets;
  sprockets.tooth_form               = form;
  const drive::ToothForm      smooth = drive::make_tooth_form(z, chain, sprockets, 0);
  const drive::ToothForm      f      = facets > 0 ? smooth.faceted(facets) : smooth;
  const std::vector<Point<2>> line   = f.polyline(facets > 0 ? 1 : 60);
  const double                outer = 0.5 * f.outside_diameter, root = 0.5 * f.root_diameter;

  std::mt19937                           random(7);
  std::uniform_real_distribution<double> uniform(0., 1.);
  double                                 worst = 0., mismatch = 0., gap_error = 0.;
  for (int i = 0; i < 2000; ++i)
    {
      const double   angle  = 2. * dealii::numbers::PI * uniform(random);
      const double   radius = root - 2e-3 + uniform(random) * (outer - root + 8e-3);
      const Point<2> p(radius * std::cos(angle), radius * std::sin(angle));
      const auto     q = f.closest_point(p);
      worst            = std::max(worst, std::abs(q.distance - distance_to_polyline(line, p)));
      mismatch         = std::max(mismatch, (q.point + q.distance * q.normal - p).norm());
      mismatch         = std::max(mismatch, std::abs(q.normal.norm() - 1.) * chain.pitch);
      const double off =
          std::remainder(angle - q.tooth_gap * f.pitch_angle(), 2. * dealii::numbers::PI);
      gap_error = std::max(gap_error, std::abs(off) / (0.5 * f.pitch_angle()) - 1.);
    }
  std::cout << "== " << text_of(form) << ", " << z << " teeth";
  if (facets > 0)
    {
      std::cout << " of " << facets << " chords\n";
      verdict("2000 points agree with the polyline to 1e-12 mm", worst < 1e-15);
    }
  else
    {
      std::cout << '\n';
      // a chord of the length l strays from an arc of the radius r by l^2 / (8 r)
      verdict("2000 points agree with the polyline within 0.5 um", worst < 0.5e-6);
    }
  verdict("point + distance x normal is the given point, to 1e-12 mm", mismatch < 1e-15);
  verdict("the gap is that of the point's sector", gap_error < 1e-12);

  // the distance is 1-Lipschitz, also across the sectors' borders
  double    steepest = 0.;
  const int n        = 40000;
  for (const double radius : {root + 1e-3, 0.5 * (root + outer), outer - 1e-4, outer + 1e-3})
    {
      double before = f.closest_point(Point<2>(radius, 0.)).distance;
      for (int i = 1; i <= n; ++i)
        {
          const double a = 2. * dealii::numbers::PI * i / n;
          const double after =
              f.closest_point(radius * Point<2>(std::cos(a), std::sin(a))).distance;
          steepest = std::max(steepest,
                              std::abs(after - before) * n / (2. * dealii::numbers::PI * radius));
          before   = after;
        }
    }
  verdict("distance changes by no more than the way gone", steepest < 1. + 1e-6);

  // mirror and rotation
  double asymmetry = 0.;
  for (int i = 0; i < 200; ++i)
    {
      const Point<2> p(root + uniform(random) * 8e-3, (uniform(random) - 0.5) * 8e-3);
      const double   d = f.closest_point(p).distance;
      const double   a = (i % z) * f.pitch_angle();
      asymmetry =
          std::max(asymmetry, std::abs(d - f.closest_point(Point<2>(p[0], -p[1])).distance));
      asymmetry =
          std::max(asymmetry,
                   std::abs(d - f.closest_point(Point<2>(std::cos(a) * p[0] - std::sin(a) * p[1],
                                                         std::sin(a) * p[0] + std::cos(a) * p[1]))
                                    .distance));
    }
  verdict("mirror and rotation symmetry to 1e-12 mm", asymmetry < 1e-15);

  // over the tip's edge the normal turns from the flank's to the tip's; under it is metal
  const Point<2> edge   = f.half_profile.back().begin;
  const Point<2> radial = edge / edge.norm();
  const Point<2> under(edge + 1e-5 * (Point<2>(-radial[1], radial[0]) - radial));
  compare("over the tip's edge the normal is radial",
          f.closest_point(edge + 1e-9 * radial).normal * radial,
          1.,
          6);
  verdict("a point under the tip's edge is inside", f.closest_point(under).distance < 0.);
}
} // namespace

int main()
{
  const drive::ChainDimensions chain = drive::make_chain(parameters::Chain());
  for (const auto form : {parameters::StandardForm::iso_min,
                          parameters::StandardForm::iso_max,
                          parameters::StandardForm::ansi})
    for (const unsigned int z : {9u, 15u, 42u})
      check(form, z, chain);
  check(parameters::StandardForm::iso_min, 15, chain, 16);
  check(parameters::StandardForm::iso_max, 42, chain, 96);
  check(parameters::StandardForm::ansi, 9, chain, 24);
}
