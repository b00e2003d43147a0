// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/outline.h>

#include <cmath>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;

namespace
{
Point<2> on_circle(const Point<2> &centre, const double radius, const double angle)
{
  return centre + radius * Point<2>(std::cos(angle), std::sin(angle));
}
} // namespace

Segment line_segment(const Point<2> &begin, const Point<2> &end)
{
  Segment line{};
  line.kind  = Segment::Kind::line;
  line.begin = begin;
  line.end   = end;
  return line;
}

Segment arc_segment(const Point<2> &centre,
                    const double    radius,
                    const double    begin_angle,
                    const double    end_angle)
{
  Segment arc;
  arc.kind        = end_angle > begin_angle ? Segment::Kind::convex : Segment::Kind::concave;
  arc.begin       = on_circle(centre, radius, begin_angle);
  arc.end         = on_circle(centre, radius, end_angle);
  arc.centre      = centre;
  arc.radius      = radius;
  arc.begin_angle = begin_angle;
  arc.end_angle   = end_angle;
  arc.middle      = on_circle(Point<2>(), 1., 0.5 * (begin_angle + end_angle));
  arc.half_cosine = std::cos(0.5 * (end_angle - begin_angle));
  return arc;
}

Point<2> Segment::point(const double t) const
{
  if (kind == Kind::line)
    return begin + t * (end - begin);
  return on_circle(centre, radius, begin_angle + t * (end_angle - begin_angle));
}

double Segment::length() const
{
  return kind == Kind::line ? begin.distance(end) : radius * std::abs(end_angle - begin_angle);
}

double Segment::area() const
{
  if (kind == Kind::line)
    return 0.5 * cross(begin, end);
  // 1/2 int (c + r e) x (r e') da, e = (cos a, sin a)
  const double sine   = std::sin(end_angle) - std::sin(begin_angle);
  const double cosine = std::cos(end_angle) - std::cos(begin_angle);
  return 0.5 * radius *
         (radius * (end_angle - begin_angle) + centre[0] * sine - centre[1] * cosine);
}

double Segment::polar_moment() const
{
  if (kind == Kind::line)
    {
      const Tensor<1, 2> d = end - begin;
      return 0.25 * cross(begin, d) * (begin.square() + begin * d + d.norm_square() / 3.);
    }
  // 1/4 int |c + r e|^2 (r^2 + r c.e) da, in powers of s = c.e = |c| cos(a - b)
  const double sweep = end_angle - begin_angle, r = radius, c2 = centre.square();
  const double b = std::atan2(centre[1], centre[0]);
  const double s = centre[0] * (std::sin(end_angle) - std::sin(begin_angle)) -
                   centre[1] * (std::cos(end_angle) - std::cos(begin_angle));
  const double s2 =
      c2 *
      (0.5 * sweep + 0.25 * (std::sin(2. * (end_angle - b)) - std::sin(2. * (begin_angle - b))));
  return 0.25 *
         ((c2 + r * r) * r * r * sweep + ((c2 + r * r) * r + 2. * r * r * r) * s + 2. * r * r * s2);
}

double Segment::moment_about_x() const
{
  if (kind == Kind::line)
    {
      const double a = begin[1], b = end[1];
      return -(end[0] - begin[0]) * (a * a * a + a * a * b + a * b * b + b * b * b) / 12.;
    }
  // -1/3 int (c_y + r sin a)^3 (-r sin a) da
  const auto primitive = [&](const double a) {
    const double y = centre[1], r = radius, c = std::cos(a);
    const double sine2 = 0.5 * a - 0.25 * std::sin(2. * a);                            // int sin^2
    const double sine3 = c * c * c / 3. - c;                                           // int sin^3
    const double sine4 = 0.375 * a - 0.25 * std::sin(2. * a) + std::sin(4. * a) / 32.; // int sin^4
    return r / 3. *
           (-y * y * y * c + 3. * y * y * r * sine2 + 3. * y * r * r * sine3 + r * r * r * sine4);
  };
  return primitive(end_angle) - primitive(begin_angle);
}
} // namespace chaindrive::drive
