// SPDX-License-Identifier: LGPL-2.1-or-later
// The line of a guide: an arc is the circle through its points, a spline goes through its own and
// is straight where they are; nearest points are those of a search among very many, whatever the
// search begins with; beyond the ends nothing is behind the line.
#include <chaindrive/path/curve.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace chaindrive::path;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
void verdict(const std::string &what, const bool holds)
{
  std::cout << "  " << what << ": " << (holds ? "yes" : "NO") << '\n';
}

Point<2> on_circle(const Point<2> &centre, const double radius, const double angle)
{
  return Point<2>(centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle));
}

/// The least distance of @p p from many points of @p curve.
double by_search(const Curve &curve, const Point<2> &p)
{
  double         least = 1e9;
  const unsigned n     = 20000 * curve.n_pieces();
  for (unsigned int i = 0; i <= n; ++i)
    least = std::min(least, p.distance(curve.at(static_cast<double>(i) * curve.n_pieces() / n)));
  return least;
}
} // namespace

int main()
{
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> number(0., 1.);
  const Point<2>                         centre(0.1, -0.02);
  const double                           radius = 0.15;
  for (const double turn : {1., -1.})
    {
      std::cout << (turn > 0. ? "arc, counter-clockwise\n" : "arc, clockwise\n");
      const double first = 0.4, swept = 2.1;
      Curve        arc = Curve::arc({on_circle(centre, radius, first),
                                     on_circle(centre, radius, first + 0.3 * turn * swept),
                                     on_circle(centre, radius, first + turn * swept)});
      double       off = 0., direction = 0., hints = 0.;
      for (unsigned int i = 0; i < 200; ++i)
        {
          const double   away = -0.02 + 0.04 * number(random);
          const double   at   = first + turn * swept * (0.001 + 0.998 * number(random));
          const Point<2> p    = on_circle(centre, radius + away, at);
          unsigned int   hint = 1000, other = random() % arc.n_pieces();
          const Nearest  nearest = arc.nearest(p, hint), again = arc.nearest(p, other);
          // its material is to the right of the way from the first point to the last
          off       = std::max(off, std::abs(nearest.distance + turn * away));
          direction = std::max(direction,
                               (nearest.normal + turn * (p - centre) / p.distance(centre)).norm());
          hints     = std::max(hints, std::abs(nearest.distance - again.distance));
        }
      verdict("distances to 1e-10 of the radius", off < 1e-10 * radius);
      verdict("normals to 1e-7", direction < 1e-7);
      verdict("the same from any hint to 1e-15", hints < 1e-15);
      verdict("length to 1e-4", std::abs(arc.length() / (radius * swept) - 1.) < 1e-4);
      const Point<2> beyond = on_circle(centre, radius - turn * 0.01, first - turn * 0.1);
      unsigned int   hint   = 1000;
      verdict("beyond its end it is away",
              std::abs(arc.nearest(beyond, hint).distance - beyond.distance(arc.begin())) < 1e-15);
      arc.reverse();
      const Point<2> inside = on_circle(centre, radius - 0.01, first + 0.5 * turn * swept);
      verdict("reversed, the other side is the chain's",
              std::abs(arc.nearest(inside, hint).distance + turn * 0.01) < 1e-10);
    }

  std::cout << "spline\n";
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i < 7; ++i)
    points.emplace_back(0.05 * i + 0.01 * number(random), 0.02 * number(random));
  const Curve spline = Curve::spline(points);
  double      off = 0., through = 0.;
  for (unsigned int i = 0; i < points.size(); ++i)
    through = std::max(through, points[i].distance(spline.at(i)));
  for (unsigned int i = 0; i < 40; ++i)
    {
      const Point<2> p(0.02 + 0.26 * number(random), -0.02 + 0.05 * number(random));
      unsigned int   hint = 1000;
      off                 = std::max(off,
                     std::abs(std::abs(spline.nearest(p, hint).distance) - by_search(spline, p)));
    }
  verdict("it goes through its points to 1e-16", through < 1e-16);
  verdict("distances are those of a search to 1e-8", off < 1e-8);
  double       jump = 0., end = 0.;
  const double h    = 1e-4;
  const auto   bend = [&](const double s) {
    return (spline.at(s + h) - spline.at(s) - (spline.at(s) - spline.at(s - h))) / (h * h);
  };
  for (unsigned int i = 1; i + 1 < points.size(); ++i)
    {
      const double before = points[i].distance(points[i - 1]),
                   after  = points[i + 1].distance(points[i]);
      jump                = std::max(
          jump,
          (bend(i - 2. * h) / (before * before) - bend(i + 2. * h) / (after * after)).norm() *
              0.05);
    }
  end = (bend(2. * h) / points[1].distance(points[0])).norm();
  verdict("its curvature has no jumps beyond 0.02 of that of a radius of 50 mm", jump < 0.02);
  verdict("its ends are straight to 1e-2", end < 1e-2);

  const Curve   line = Curve::spline({Point<2>(0., 0.), Point<2>(0.1, 0.), Point<2>(0.3, 0.)});
  unsigned int  hint = 5;
  const Nearest near = line.nearest(Point<2>(0.17, 0.03), hint);
  verdict("through points of a line it is straight",
          std::abs(near.distance - 0.03) < 1e-16 && std::abs(near.normal[1] - 1.) < 1e-15);
}
