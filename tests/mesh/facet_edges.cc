// SPDX-License-Identifier: LGPL-2.1-or-later
// A box without its lid: flat faces, sharp edges and corners, an open rim. The normal's continuity
// over a doubly curved surface of irregular quadrilaterals. Above the edge between two of them
// round-off does not decide which one a point is in.

#include <chaindrive/mesh/surface/facet_surface.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;
using dealii::Point;

namespace
{
void show(const mesh::FacetSurface &surface, const Point<3> &p, const std::string &expected)
{
  const auto projection = surface.closest_point(p, 1.2);
  std::cout << expected << ": ";
  if (projection.found)
    std::cout << projection.distance << " at " << projection.point << " normal "
              << projection.normal << '\n';
  else
    std::cout << "none\n";
}

/// A sphere as a cube blown up: six faces of n x n quadrilaterals, three of which meet in a corner.
mesh::FacetSurface sphere(const unsigned int n)
{
  std::vector<Point<3>>                    vertices;
  std::vector<std::array<unsigned int, 4>> quads;
  const auto                               number = [&](const Point<3> &x) {
    for (unsigned int v = 0; v < vertices.size(); ++v)
      if (vertices[v].distance(x) < 1e-9)
        return v;
    vertices.push_back(x);
    return static_cast<unsigned int>(vertices.size() - 1);
  };
  for (unsigned int d = 0; d < 3; ++d)
    for (const double side : {-1., 1.})
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            std::array<unsigned int, 4> q;
            for (unsigned int v = 0; v < 4; ++v)
              {
                const double a = 0.25 * dealii::numbers::PI;
                Point<3>     x;
                x[d]           = side;
                x[(d + 1) % 3] = std::tan(a * (2. * (i + (v == 1 || v == 2)) / n - 1.));
                x[(d + 2) % 3] = std::tan(a * (2. * (j + (v > 1)) / n - 1.)) * side;
                q[v]           = number(Point<3>(x / x.norm()));
              }
            quads.push_back(q);
          }
  return mesh::FacetSurface(vertices, quads);
}
} // namespace

int main()
{
  std::cout << std::fixed << std::setprecision(6);
  std::vector<Point<3>> x;
  for (unsigned int v = 0; v < 8; ++v)
    x.emplace_back(v & 1, (v >> 1) & 1, v >> 2);
  const mesh::FacetSurface box(
      x, {{{0, 2, 3, 1}}, {{0, 1, 5, 4}}, {{1, 3, 7, 5}}, {{3, 2, 6, 7}}, {{2, 0, 4, 6}}});
  show(box, {0.5, 1.25, 0.5}, "face, 0.25 along y");
  show(box, {1.3, 1.4, 0.5}, "edge, 0.5");
  show(box, {-0.2, -0.1, -0.2}, "corner, 0.3");
  show(box, {0.9, 0.5, 0.5}, "inside, -0.1 along x");
  show(box, {0.5, 0.5, 1.5}, "past the rim, inside");
  show(box, {1.5, 0.5, 1.1}, "past the rim, outside");
  show(box, {0.5, 4., 0.5}, "out of reach");

  std::cout << "sphere: quadrilaterals, error of the distance over the sagitta in %, order; "
            << "largest jump of the normal over the largest angle between facets, in %\n";
  double last = 0.;
  for (const unsigned int n : {4, 8, 16})
    {
      const auto ball  = sphere(n);
      double     error = 0., jump = 0.;
      for (unsigned int k = 0; k < 12; ++k)
        {
          dealii::Tensor<1, 3> before;
          const unsigned int   m = 1000;
          for (unsigned int i = 0; i < m; ++i)
            {
              // circles in planes that cross facets at all angles and pass near the corners
              const double   t = 2. * dealii::numbers::PI * i / m, tilt = 0.262 * k;
              const Point<3> e(std::cos(t) * std::cos(tilt) - std::sin(t) * std::sin(tilt) * 0.7071,
                               std::cos(t) * std::sin(tilt) + std::sin(t) * std::cos(tilt) * 0.7071,
                               std::sin(t) * 0.7071);
              const auto     projection = ball.closest_point(Point<3>(1.2 * e), 1.);
              if (!projection.found)
                std::cout << "missed " << e << '\n';
              error = std::max(error, std::abs(projection.distance - 0.2));
              if (i > 0)
                jump = std::max(jump, (projection.normal - before).norm());
              before = projection.normal;
            }
        }
      // two successive points are 2 pi / m apart, and so are their normals
      const double angle   = 0.5 * dealii::numbers::PI / n;
      const double sagitta = 1. - std::cos(0.5 * angle * std::sqrt(2.));
      std::cout << 6 * n * n << ' ' << std::setprecision(3) << 100. * error / sagitta;
      if (last > 0.)
        std::cout << ' ' << std::setprecision(1) << std::log2(last / error);
      std::cout << ' ' << std::setprecision(2)
                << 100. * (jump - 2. * dealii::numbers::PI / 1000.) / angle << '\n';
      last = error;
    }

  // facets on either side of the plane z = 0 are mirror images, and points in it as far from both
  const auto ball  = sphere(8);
  const auto facet = [&ball](const double t, const double z, const unsigned int hint) {
    return ball.closest_point(Point<3>(1.2 * std::cos(t), 1.2 * std::sin(t), z), 1., hint).facet;
  };
  bool         stays = true, same = true;
  unsigned int edges = 0;
  for (double t = 0.013; t < 2. * dealii::numbers::PI; t += 0.05)
    {
      const unsigned int none = ball.n_facets(), above = facet(t, 0.01, none),
                         below = facet(t, -0.01, none);
      edges += above != below;
      for (const double z : {-2e-17, -1e-17, 0., 1e-17, 2e-17})
        {
          stays = stays && facet(t, z, above) == above && facet(t, z, below) == below;
          same  = same && facet(t, z, none) == facet(t, 0., none);
        }
    }
  std::cout << edges << " points above edges, moved by round-off: stay where they were: "
            << (stays ? "yes" : "NO") << ", get the same facet: " << (same ? "yes" : "NO") << '\n';
}
