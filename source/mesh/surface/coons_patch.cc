// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface/coons_patch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::mesh
{
using dealii::Point;
using dealii::Tensor;

namespace
{
void add(Ray &sum, const double factor, const Ray &ray)
{
  sum.x += factor * ray.x;
  sum.n += factor * ray.n;
}

double determinant(const Tensor<1, 3> &a, const Tensor<1, 3> &b, const Tensor<1, 3> &c)
{
  return dealii::cross_product_3d(a, b) * c;
}

/// How far a projection may lie outside of the unit square to count as inside.
constexpr double round_off = 1e-9;
} // namespace

CoonsPatch::CoonsPatch(const std::array<Ray, 4> &corners, const std::array<Edge, 4> &edges)
    : corners_(corners), edges_(edges)
{
  const auto &c = corners_;
  size_         = std::max((c[2].x - c[0].x).norm(), (c[3].x - c[1].x).norm());

  axes_[0] = c[1].x + c[2].x - c[0].x - c[3].x;
  axes_[0] /= axes_[0].norm();
  axes_[2] = dealii::cross_product_3d(c[2].x - c[0].x, c[3].x - c[1].x);
  axes_[2] -= (axes_[2] * axes_[0]) * axes_[0];
  axes_[2] /= axes_[2].norm();
  axes_[1] = dealii::cross_product_3d(axes_[2], axes_[0]);

  evaluate(0.5, 0.5, middle_[0], middle_[1], middle_[2]);

  // Samples find the extent of the patch; the cubic edges pass a sample by less than a tenth of
  // their height between two samples.
  constexpr unsigned int n = 6;
  std::array<double, 3>  low, high;
  low.fill(1e300);
  high.fill(-1e300);
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j)
      {
        Ray s, s_u, s_v;
        evaluate(double(i) / n, double(j) / n, s, s_u, s_v);
        for (unsigned int d = 0; d < 3; ++d)
          {
            low[d]  = std::min(low[d], s.x * axes_[d]);
            high[d] = std::max(high[d], s.x * axes_[d]);
          }
      }
  Tensor<1, 3> centre;
  for (unsigned int d = 0; d < 3; ++d)
    {
      centre += 0.5 * (low[d] + high[d]) * axes_[d];
      half_[d] = 0.55 * (high[d] - low[d]) + 1e-9 * size_;
    }
  centre_ = Point<3>(centre);
}

void CoonsPatch::evaluate_edge(const unsigned int e, const double t, Ray &c, Ray &c_t) const
{
  const Ray   &a = corners_[e], &b = corners_[(e + 1) % 4];
  const Edge  &edge = edges_[e];
  const double s    = 1. - t;
  // cubic Hermite basis
  c = c_t = Ray();
  add(c, s * s * (1. + 2. * t), a);
  add(c, t * t * (1. + 2. * s), b);
  add(c, s * s * t, edge.first);
  add(c, -t * t * s, edge.last);
  add(c_t, -6. * s * t, a);
  add(c_t, 6. * s * t, b);
  add(c_t, s * (s - 2. * t), edge.first);
  add(c_t, t * (t - 2. * s), edge.last);
}

void CoonsPatch::evaluate(const double u, const double v, Ray &s, Ray &s_u, Ray &s_v) const
{
  const double                a = 1. - u, b = 1. - v;
  const std::array<double, 4> parameter = {{u, v, a, b}}; // along each edge
  const std::array<double, 4> weight    = {{b, u, v, a}}; // of each edge in the blend
  // signs of the derivatives of the two
  constexpr std::array<int, 4> along = {{1, 1, -1, -1}}, across = {{-1, 1, 1, -1}};

  s = s_u = s_v = Ray();
  for (unsigned int e = 0; e < 4; ++e)
    {
      Ray c, c_t;
      evaluate_edge(e, parameter[e], c, c_t);
      add(s, weight[e], c);
      Ray &s_along = (e % 2 == 0 ? s_u : s_v), &s_across = (e % 2 == 0 ? s_v : s_u);
      add(s_along, weight[e] * along[e], c_t);
      add(s_across, across[e], c);
    }
  const auto &c = corners_;
  add(s, -a * b, c[0]);
  add(s, -u * b, c[1]);
  add(s, -u * v, c[2]);
  add(s, -a * v, c[3]);
  add(s_u, b, c[0]);
  add(s_u, -b, c[1]);
  add(s_u, -v, c[2]);
  add(s_u, v, c[3]);
  add(s_v, a, c[0]);
  add(s_v, u, c[1]);
  add(s_v, -u, c[2]);
  add(s_v, -a, c[3]);
}

CoonsPatch::Projection CoonsPatch::project(const Point<3> &p) const
{
  // Newton's method for p = x(u, v) + d n(u, v). The distance is eliminated at each iterate, which
  // makes the method exact for arcs and keeps it steady near their centre, where every point is a
  // projection. The first step, from the middle, costs little and tells most of the facets that
  // look at p but do not hold its projection.
  double       u = 0.5, v = 0.5, d = 0., du = 0., dv = 0.;
  Ray          s = middle_[0], s_u = middle_[1], s_v = middle_[2];
  Tensor<1, 3> rest;

  const auto look = [&]() {
    d    = (p - Point<3>(s.x)) * s.n / s.n.norm_square();
    rest = p - Point<3>(s.x) - d * s.n;
  };
  const auto step = [&]() {
    const Tensor<1, 3> a = s_u.x + d * s_u.n, b = s_v.x + d * s_v.n;
    const double       det = determinant(a, b, s.n);
    if (std::abs(det) < 1e-12 * size_ * size_)
      return false;
    du = determinant(rest, b, s.n) / det;
    dv = determinant(a, rest, s.n) / det;
    return true;
  };

  Projection projection;
  look();
  bool         converged = rest.norm() < 1e-13 * size_;
  unsigned int n_outside = 0;
  for (unsigned int iteration = 0; iteration < 25 && !converged && step(); ++iteration)
    {
      if (iteration == 0 && std::max(std::abs(du), std::abs(dv)) > 3.)
        {
          projection.inside = false;
          projection.u = projection.v = 0.5;
          projection.distance = projection.obliquity = std::numeric_limits<double>::max();
          return projection;
        }
      const double u_0 = u, v_0 = v;
      u = std::clamp(u + std::clamp(du, -1., 1.), -0.5, 1.5);
      v = std::clamp(v + std::clamp(dv, -1., 1.), -0.5, 1.5);
      if (std::max(std::abs(u - 0.5), std::abs(v - 0.5)) == 1. && ++n_outside == 2)
        break; // it wants to go far outside
      evaluate(u, v, s, s_u, s_v);
      look();
      converged =
          rest.norm() < 1e-13 * size_ || (std::abs(u - u_0) < 1e-14 && std::abs(v - v_0) < 1e-14);
    }

  projection.inside =
      converged && u > -round_off && u < 1. + round_off && v > -round_off && v < 1. + round_off;
  if (!projection.inside)
    {
      u = std::clamp(u, 0., 1.);
      v = std::clamp(v, 0., 1.);
      evaluate(u, v, s, s_u, s_v);
      look();
    }
  const double length  = s.n.norm();
  projection.u         = u;
  projection.v         = v;
  projection.ray.x     = s.x;
  projection.ray.n     = s.n / length;
  projection.distance  = d * length;
  projection.obliquity = rest.norm();
  return projection;
}

CoonsPatch::Projection CoonsPatch::project_on_edge(const Point<3> &p, const unsigned int e) const
{
  // The zero of g(t) = (c(t) - p) . c'(t), by Newton's method inside a shrinking bracket.
  Ray        c, c_t;
  const auto slope = [&](const double t) {
    evaluate_edge(e, t, c, c_t);
    return (c.x - p) * c_t.x;
  };
  // how far p looks past the ends, as a fraction of the edge
  const double before = slope(0.) / c_t.x.norm_square();
  const double behind = -slope(1.) / c_t.x.norm_square();
  double       t      = before >= 0. ? 0. : 1.;
  if (before < 0. && behind < 0.)
    {
      double low = 0., high = 1.;
      t = 0.5;
      for (unsigned int iteration = 0; iteration < 60 && high - low > 1e-14; ++iteration)
        {
          const double g = slope(t), old = t;
          (g < 0. ? low : high) = t;
          t -= g / c_t.x.norm_square();
          if (t <= low || t >= high)
            t = 0.5 * (low + high);
          if (std::abs(t - old) < 1e-14)
            break;
        }
    }
  slope(t);

  Projection                                 projection;
  const std::array<std::array<double, 2>, 4> corner = {
      {{{0., 0.}}, {{1., 0.}}, {{1., 1.}}, {{0., 1.}}}};
  const auto &first = corner[e], &last = corner[(e + 1) % 4];
  projection.u         = (1. - t) * first[0] + t * last[0];
  projection.v         = (1. - t) * first[1] + t * last[1];
  projection.ray.x     = c.x;
  projection.obliquity = 0.;
  const Tensor<1, 3> r = p - Point<3>(c.x);
  projection.distance  = r.norm();
  // The sides are taken as flat here; a facet that is curved has its projection before this fails.
  const auto over = [&r, &projection](const Tensor<1, 3> &inward) {
    return r * inward > 0.3 * projection.distance;
  };
  projection.inside = !(edges_[e].ends_on_rim[0] && before > round_off) &&
                      !(edges_[e].ends_on_rim[1] && behind > round_off) &&
                      !over(edges_[e].inward[0]) && !over(edges_[e].inward[1]);
  if (projection.distance > 1e-12 * size_)
    {
      projection.ray.n = r / projection.distance;
      if (r * edges_[e].outward < 0.)
        {
          projection.ray.n *= -1.;
          projection.distance *= -1.;
        }
    }
  else
    projection.ray.n = edges_[e].outward;
  return projection;
}

double CoonsPatch::distance_bound(const Point<3> &p) const
{
  const Tensor<1, 3> local  = p - centre_;
  double             square = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    {
      const double beyond = std::abs(local * axes_[d]) - half_[d];
      if (beyond > 0.)
        square += beyond * beyond;
    }
  return std::sqrt(square);
}

dealii::BoundingBox<3> CoonsPatch::bounding_box() const
{
  Point<3> low = centre_, high = centre_;
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int a = 0; a < 3; ++a)
      {
        low[d] -= half_[a] * std::abs(axes_[a][d]);
        high[d] += half_[a] * std::abs(axes_[a][d]);
      }
  return dealii::BoundingBox<3>({low, high});
}
} // namespace chaindrive::mesh
