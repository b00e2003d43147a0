// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/plate.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::numbers::PI;

namespace
{
double square(const double x) { return x * x; }

Plate make_plate(const double pitch,
                 const double hole,
                 const double height,
                 const double waist_ratio,
                 const double thickness)
{
  return {pitch, hole, height, waist_ratio * height, thickness};
}
} // namespace

Plate inner_plate(const ChainDimensions &c)
{
  return make_plate(c.inner_hole_pitch,
                    c.bush_diameter,
                    c.inner_plate_height,
                    c.waist_ratio,
                    c.inner_plate_thickness);
}

Plate outer_plate(const ChainDimensions &c)
{
  return make_plate(c.outer_hole_pitch,
                    c.pin_diameter,
                    c.outer_plate_height,
                    c.waist_ratio,
                    c.outer_plate_thickness);
}

double Plate::waist_radius() const
{
  return 0.25 * (square(hole_pitch) + square(waist) - square(height)) / (height - waist);
}

double Plate::tangency_angle() const
{
  return has_waist() ? std::atan2(0.5 * waist + waist_radius(), 0.5 * hole_pitch) : 0.5 * PI;
}

double Plate::half_height(const double x) const
{
  const double from_hole = std::abs(x) - 0.5 * hole_pitch, r = 0.5 * height;
  if (from_hole > -r * std::cos(tangency_angle()))
    return from_hole < r ? std::sqrt(square(r) - square(from_hole)) : 0.;
  if (!has_waist())
    return r;
  const double rw = waist_radius();
  return 0.5 * waist + rw - std::sqrt(square(rw) - square(x));
}

double Plate::net_height(const double x) const
{
  const double from_hole = std::abs(x) - 0.5 * hole_pitch, r = 0.5 * hole_diameter;
  const double hole = std::abs(from_hole) < r ? std::sqrt(square(r) - square(from_hole)) : 0.;
  return 2. * (half_height(x) - hole);
}

std::vector<Segment> Plate::outline() const
{
  const Point<2> right(0.5 * hole_pitch, 0.), left(-0.5 * hole_pitch, 0.);
  const double   r = 0.5 * height, end = PI - tangency_angle(); // polar angle at the right hole

  std::vector<Segment> segments;
  const auto           waist_side = [&](const double side) {
    if (has_waist())
      {
        const double   rw = waist_radius();
        const Point<2> centre(0., side * (0.5 * waist + rw));
        const double   half = 0.5 * PI - tangency_angle(); // of the arc, from its middle
        segments.push_back(
            arc_segment(centre, rw, -side * 0.5 * PI + half, -side * 0.5 * PI - half));
      }
    else
      segments.push_back(
          line_segment(Point<2>(side * right[0], side * r), Point<2>(side * left[0], side * r)));
  };
  segments.push_back(arc_segment(right, r, 0., end));
  waist_side(1.);
  segments.push_back(arc_segment(left, r, PI - end, PI + end));
  waist_side(-1.);
  segments.push_back(arc_segment(right, r, 2. * PI - end, 2. * PI));
  return segments;
}

double Plate::area() const
{
  double sum = -0.5 * PI * square(hole_diameter);
  for (const Segment &s : outline())
    sum += s.area();
  return sum;
}

double Plate::moment_about_x() const
{
  double sum = -PI * square(square(hole_diameter)) / 32.; // two holes, pi d^4 / 64 each
  for (const Segment &s : outline())
    sum += s.moment_about_x();
  return sum;
}

double Plate::moment_about_y() const
{
  const double hole = 0.25 * PI * square(hole_diameter);
  double       sum  = -2. * hole * (square(0.25 * hole_diameter) + square(0.5 * hole_pitch));
  for (const Segment &s : outline())
    sum += s.polar_moment() - s.moment_about_x();
  return sum;
}
} // namespace chaindrive::drive
