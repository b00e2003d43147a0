// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/path/curve.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::path
{
using dealii::Point;
using Vector = dealii::Tensor<1, 2>;

namespace
{
Vector left_of(const Vector &v)
{
  Vector result;
  result[0] = 0. - v[1];
  result[1] = v[0];
  return result;
}

/// Second derivatives at the @p values of a natural cubic spline over @p knots, component @p d.
std::vector<double> curvatures(const std::vector<double>   &knots,
                               const std::vector<Point<2>> &values,
                               const unsigned int           d)
{
  const std::size_t   n = knots.size();
  std::vector<double> second(n, 0.), factor(n, 0.);
  for (std::size_t i = 1; i + 1 < n; ++i)
    {
      const double h0 = knots[i] - knots[i - 1], h1 = knots[i + 1] - knots[i];
      const double pivot = 2. * (h0 + h1) - h0 * factor[i - 1];
      factor[i]          = h1 / pivot;
      second[i] =
          (6. * ((values[i + 1][d] - values[i][d]) / h1 - (values[i][d] - values[i - 1][d]) / h0) -
           h0 * second[i - 1]) /
          pivot;
    }
  for (std::size_t i = n - 1; i-- > 1;)
    second[i] -= factor[i] * second[i + 1];
  return second;
}
} // namespace

Curve Curve::spline(const std::vector<Point<2>> &points)
{
  std::vector<double> knots{0.};
  for (std::size_t i = 1; i < points.size(); ++i)
    knots.push_back(knots.back() + points[i].distance(points[i - 1]));
  Curve curve;
  curve.pieces_.resize(points.size() - 1);
  for (unsigned int d = 0; d < 2; ++d)
    {
      const std::vector<double> second = curvatures(knots, points, d);
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        {
          const double h = knots[i + 1] - knots[i], h2 = h * h;
          Piece       &piece = curve.pieces_[i];
          piece.a[d]         = points[i][d];
          piece.b[d] = points[i + 1][d] - points[i][d] - h2 * (2. * second[i] + second[i + 1]) / 6.;
          piece.c[d] = 0.5 * h2 * second[i];
          piece.d[d] = h2 * (second[i + 1] - second[i]) / 6.;
        }
    }
  return curve;
}

// Cubics that have position and direction of the circle at both ends; over 5 degrees they are off
// by 1e-11 of its radius.
Curve Curve::arc(const std::vector<Point<2>> &points)
{
  const Vector   a = points[1] - points[0], b = points[2] - points[0];
  const double   area      = 2. * (a[0] * b[1] - a[1] * b[0]);
  Vector         to_centre = left_of(a * (b * b) - b * (a * a)) / area;
  const Point<2> centre    = points[0] + to_centre;
  const double   radius = to_centre.norm(), turn = area > 0. ? 1. : -1.;
  const auto     angle = [&centre](const Point<2> &p) {
    return std::atan2(p[1] - centre[1], p[0] - centre[0]);
  };
  const double first = angle(points[0]);
  double       swept = turn * (angle(points[2]) - first);
  swept -= 2. * dealii::numbers::PI * std::floor(swept / (2. * dealii::numbers::PI));
  const auto   n    = static_cast<unsigned int>(std::ceil(swept / (dealii::numbers::PI / 36.)));
  const double step = swept / n, handle = 4. * std::tan(0.25 * step) * radius; // 3 times Bezier's
  Curve        curve;
  for (unsigned int i = 0; i < n; ++i)
    {
      const auto on = [&](const double phi) {
        Vector result;
        result[0] = radius * std::cos(phi);
        result[1] = radius * std::sin(phi);
        return result;
      };
      const double from = first + turn * i * step, to = first + turn * (i + 1) * step;
      const Vector p0 = centre + on(from) - Point<2>(), p1 = centre + on(to) - Point<2>();
      const Vector v0 = turn * handle / radius * left_of(on(from)),
                   v1 = turn * handle / radius * left_of(on(to));
      curve.pieces_.push_back({p0, v0, 3. * (p1 - p0) - 2. * v0 - v1, 2. * (p0 - p1) + v0 + v1});
    }
  return curve;
}

void Curve::move(const Vector &by)
{
  for (Piece &piece : pieces_)
    piece.a += by;
}

Point<2> Curve::at(const double s) const
{
  const auto   i = std::min(static_cast<std::size_t>(std::max(0., s)), pieces_.size() - 1);
  const double t = s - static_cast<double>(i);
  const Piece &p = pieces_[i];
  return Point<2>(p.a + t * (p.b + t * (p.c + t * p.d)));
}

double Curve::length() const
{
  constexpr unsigned int n   = 32;
  double                 sum = 0.;
  for (std::size_t i = 0; i < pieces_.size() * n; ++i)
    sum += at(static_cast<double>(i) / n).distance(at((i + 1.) / n));
  return sum;
}

Nearest Curve::nearest(const Point<2> &p, unsigned int &hint) const
{
  const auto n = n_pieces();
  if (hint >= n)
    {
      hint = 0;
      for (unsigned int i = 1; i < n; ++i)
        if (p.distance(at(i + 0.5)) < p.distance(at(hint + 0.5)))
          hint = i;
    }
  double t = 0.5;
  for (unsigned int visited = 0; visited <= n; ++visited)
    {
      const Piece &piece = pieces_[hint];
      double       slope = 0.; // of half the square of the distance
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          const Vector way  = piece.a + t * (piece.b + t * (piece.c + t * piece.d)) - p;
          const Vector v    = piece.b + t * (2. * piece.c + 3. * t * piece.d);
          const double bend = v * v + way * (2. * piece.c + 6. * t * piece.d);
          slope             = way * v;
          const double next = std::clamp(t - slope / (bend > 0.1 * (v * v) ? bend : v * v), 0., 1.);
          const bool   found = std::abs(next - t) < 1e-14;
          t                  = next;
          if (found)
            break;
        }
      if (t == 1. && slope < 0. && hint + 1 < n)
        {
          ++hint;
          t = 0.;
        }
      else if (t == 0. && slope > 0. && hint > 0)
        {
          --hint;
          t = 1.;
        }
      else
        break;
    }
  const Piece &piece  = pieces_[hint];
  const Vector v      = piece.b + t * (2. * piece.c + 3. * t * piece.d);
  const Vector arm    = p - Point<2>(piece.a + t * (piece.b + t * (piece.c + t * piece.d)));
  Vector       normal = side_ / v.norm() * left_of(v);
  const double across = arm * normal, beside = std::abs(arm * v) / v.norm();
  const bool   is_end = (hint == 0 && t == 0.) || (hint + 1 == n && t == 1.);
  if (is_end && beside > 1e-12 && arm.norm() > 0.)
    return {arm.norm(), arm / arm.norm()};
  return {across, normal};
}
} // namespace chaindrive::path
