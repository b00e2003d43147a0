// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/// Where on a segment the point nearest to p is: between its ends (0), at its begin (-1), its end
/// (1).
struct Nearest
{
  double distance; ///< not signed
  int    end;
};

inline Nearest nearest_on(const Segment &s, const Point<2> &p)
{
  if (s.kind == Segment::Kind::line)
    {
      const Tensor<1, 2> d = s.end - s.begin, w = p - s.begin;
      const double       along = w * d, square = d.norm_square();
      if (along > 0. && along < square)
        return {std::abs(w[0] * d[1] - w[1] * d[0]) / std::sqrt(square), 0};
    }
  else
    {
      const Tensor<1, 2> w    = p - s.centre;
      const double       norm = w.norm();
      if (w * s.middle > norm * s.half_cosine)
        return {std::abs(norm - s.radius), 0};
    }
  const double begin = (p - s.begin).norm_square(), end = (p - s.end).norm_square();
  return begin < end ? Nearest{std::sqrt(begin), -1} : Nearest{std::sqrt(end), 1};
}

/// That point, and there the segment's unit normal out of the metal, which is on its left.
inline void
place(const Segment &s, const int end, const Point<2> &p, Point<2> &point, Tensor<1, 2> &normal)
{
  if (s.kind == Segment::Kind::line)
    {
      const Tensor<1, 2> d      = s.end - s.begin;
      const double       square = d.norm_square(), one = 1. / std::sqrt(square);
      point     = end == 0 ? s.begin + ((p - s.begin) * d / square) * d : end < 0 ? s.begin : s.end;
      normal[0] = d[1] * one;
      normal[1] = -d[0] * one;
      return;
    }
  if (end != 0)
    point = end < 0 ? s.begin : s.end;
  normal = (end == 0 ? p : point) - s.centre;
  normal /= normal.norm();
  if (end == 0)
    point = s.centre + s.radius * normal;
  if (s.kind == Segment::Kind::concave)
    normal = -normal;
}

inline Tensor<1, 2> rotated(const Tensor<1, 2> &v, const Tensor<1, 2> &by)
{
  Tensor<1, 2> result;
  result[0] = by[0] * v[0] - by[1] * v[1];
  result[1] = by[1] * v[0] + by[0] * v[1];
  return result;
}
/// The polar angle of @p p, 0 ... 2 pi, within 1e-5 (Abramowitz, Stegun, Handbook of Mathematical
/// Functions, 4.4.49); of the origin 0.
inline double rough_angle(const Point<2> &p)
{
  const double a = std::abs(p[0]), b = std::abs(p[1]), most = std::max(a, b);
  if (most == 0.)
    return 0.;
  const double t = std::min(a, b) / most, s = t * t;
  double       angle =
      t * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  if (b > a)
    angle = 0.5 * dealii::numbers::PI - angle;
  if (p[0] < 0.)
    angle = dealii::numbers::PI - angle;
  return p[1] < 0. ? 2. * dealii::numbers::PI - angle : angle;
}
} // namespace

Projection ToothForm::closest_point(const Point<2> &p) const
{
  // fold p into the sector 0 <= polar angle <= pi / z: the profile maps to itself under those
  // rotations and mirrors, so the point nearest to p lies in the sector of p. Gaps that have been
  // shifted map to themselves about their own middles; on tips, which are round about the axis,
  // nothing changes where sectors meet.
  const double gaps   = 0.5 + rough_angle(p) * (teeth / (2. * dealii::numbers::PI));
  const int    n_gaps = static_cast<int>(teeth);
  int          gap    = gaps < n_gaps ? static_cast<int>(gaps) : 0; // 0 of no number, too
  Tensor<1, 2> turn;
  double       x, y;
  const auto   unturn = [&](const Tensor<1, 2> &by) {
    turn = by;
    x    = turn[0] * p[0] + turn[1] * p[1];
    y    = turn[0] * p[1] - turn[1] * p[0];
  };
  const auto fold = [&]() {
    gap = gap < 0 ? gap + n_gaps : gap >= n_gaps ? gap - n_gaps : gap;
    unturn(rotations[gap]);
  };
  fold();
  // the middle of the tooth is where y / x = tan(pi / z)
  if (std::abs(y) * (1. + rotations[1][0]) > x * rotations[1][1])
    {
      gap += y < 0. ? -1 : 1;
      fold();
    }
  if (!shifted.empty())
    unturn(shifted[gap]);
  const double   side  = y < 0. ? -1. : 1.;
  const Point<2> local = Point<2>(x, side * y);

  const std::size_t n     = half_profile.size();
  std::size_t       which = 0;
  Nearest           best  = nearest_on(half_profile[0], local);
  for (std::size_t i = 1; i < n; ++i)
    {
      const Nearest found = nearest_on(half_profile[i], local);
      if (found.distance < best.distance)
        {
          best  = found;
          which = i;
        }
    }
  Point<2>     point;
  Tensor<1, 2> normal;
  place(half_profile[which], best.end, local, point, normal);

  const Tensor<1, 2> away = local - point;
  const Corner corner     = best.end == 0 ? Corner::none : corners[which + (best.end > 0 ? 1 : 0)];
  if (corner == Corner::concave || (corner == Corner::none && away * normal < 0.))
    best.distance = -best.distance;
  if (corner != Corner::none && best.distance != 0.)
    normal = away / best.distance;

  point[1] *= side;
  normal[1] *= side;
  return {best.distance,
          Point<2>(rotated(point, turn)),
          rotated(normal, turn),
          static_cast<unsigned int>(gap)};
}

std::vector<Point<2>> ToothForm::half_polyline(const unsigned int per_segment) const
{
  std::vector<Point<2>> points = {half_profile.front().begin};
  for (const Segment &s : half_profile)
    for (unsigned int i = 1; i <= per_segment; ++i)
      points.push_back(s.point(static_cast<double>(i) / per_segment));
  return points;
}

std::vector<Point<2>> ToothForm::polyline(const unsigned int per_segment) const
{
  const std::vector<Point<2>> half = half_polyline(per_segment);
  std::vector<Point<2>>       points;
  for (unsigned int k = 0; k < teeth; ++k)
    {
      for (std::size_t i = 0; i + 1 < half.size(); ++i)
        points.emplace_back(rotated(half[i], rotations[k]));
      for (std::size_t i = half.size() - 1; i > 0; --i)
        points.emplace_back(rotated(Point<2>(half[i][0], -half[i][1]), rotations[(k + 1) % teeth]));
    }
  return points;
}
} // namespace chaindrive::drive
