// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface/cylinder_grid.h>

#include <chaindrive/utilities/errors.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace chaindrive::mesh
{
using dealii::Point;
using dealii::numbers::PI;

namespace
{
constexpr double tolerance = 1e-6; // of the radius

/// Centre of the circle through three points.
Point<2> circumcentre(const Point<2> &a, const Point<2> &b, const Point<2> &c)
{
  const auto   u = b - a, v = c - a;
  const double twice = 2. * (u[0] * v[1] - u[1] * v[0]);
  return a + Point<2>(v[1] * u.norm_square() - u[1] * v.norm_square(),
                      u[0] * v.norm_square() - v[0] * u.norm_square()) /
                 twice;
}

/// The different ones of some values, ascending; those closer than @p distance are one.
std::vector<double> different(std::vector<double> values, const double distance)
{
  std::sort(values.begin(), values.end());
  std::vector<double> result;
  for (const double x : values)
    if (result.empty() || x - result.back() > distance)
      result.push_back(x);
  return result;
}

/// Index of the one of @p values that is nearest to @p x.
unsigned int nearest(const std::vector<double> &values, const double x)
{
  const auto distance = [x](const double a, const double b) {
    return std::abs(a - x) < std::abs(b - x);
  };
  return static_cast<unsigned int>(std::min_element(values.begin(), values.end(), distance) -
                                   values.begin());
}
} // namespace

CylinderGrid::CylinderGrid(const Part &part, const Surface side) : half(part.half)
{
  const auto refuse = [&](const std::string &reason) {
    throw InputError("The side '" + surface_name(side) + "' of the " + part.name +
                     " cannot take part in elastic contact: " + reason + ".");
  };

  std::map<unsigned int, Point<3>> points;
  unsigned int                     n_faces = 0;
  for (const auto &cell : part.mesh->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == side)
        {
          ++n_faces;
          for (const unsigned int v : cell->face(f)->vertex_indices())
            points[cell->face(f)->vertex_index(v)] = cell->face(f)->vertex(v);
        }
  if (n_faces == 0)
    refuse("it has no faces");

  // The axis: from the first vertex, the one farthest from it and one between the two.
  const auto     flat = [](const Point<3> &p) { return Point<2>(p[0], p[1]); };
  const Point<2> a    = flat(points.begin()->second);
  Point<2>       b = a, c = a;
  for (const auto &[vertex, p] : points)
    if (flat(p).distance(a) > b.distance(a))
      b = flat(p);
  const auto off_line = [&](const Point<2> &p) {
    return std::abs((p - a)[0] * (b - a)[1] - (p - a)[1] * (b - a)[0]);
  };
  for (const auto &[vertex, p] : points)
    if (off_line(flat(p)) > off_line(c))
      c = flat(p);
  if (!(off_line(c) > tolerance * (b - a).norm_square()))
    refuse("it is no cylinder about an axis parallel to z");
  axis   = circumcentre(a, b, c);
  radius = axis.distance(a);

  std::vector<double> all_rings, all_angles;
  const auto          angle_of = [&](const Point<3> &p) {
    double angle = std::atan2(p[1] - axis[1], p[0] - axis[0]);
    if (angle < -tolerance)
      angle += 2. * PI;
    return angle;
  };
  for (const auto &[vertex, p] : points)
    {
      if (!(std::abs(axis.distance(flat(p)) - radius) < tolerance * radius))
        refuse("it is no cylinder about an axis parallel to z");
      all_rings.push_back(p[2]);
      all_angles.push_back(angle_of(p));
    }
  rings  = different(all_rings, tolerance * radius);
  angles = different(all_angles, tolerance);

  constexpr unsigned int none = static_cast<unsigned int>(-1);
  vertex.assign(std::size_t(n_rings()) * n_circumferential(), none);
  for (const auto &[number, p] : points)
    vertex[nearest(rings, p[2]) * n_circumferential() + nearest(angles, angle_of(p))] = number;
  if (n_rings() < 2 || n_circumferential() < 3 || points.size() != vertex.size() ||
      std::count(vertex.begin(), vertex.end(), none) > 0 ||
      n_faces != (n_rings() - 1) * n_circumferential())
    refuse(
        "its vertices are no grid of rings along the axis and circumferential positions around it");
}

double CylinderGrid::area(const unsigned int ring, const unsigned int column) const
{
  const unsigned int n    = n_circumferential();
  const double       next = angles[(column + 1) % n] + (column + 1 == n ? 2. * PI : 0.);
  const double       last = angles[(column + n - 1) % n] - (column == 0 ? 2. * PI : 0.);
  const double       from = rings[ring == 0 ? 0 : ring - 1];
  const double       to   = rings[std::min(ring + 1, n_rings() - 1)];
  return radius * 0.5 * (next - last) * 0.5 * (to - from);
}

double CylinderGrid::depth(const double z) const
{
  const double from_end = rings.back() - z;
  return half ? from_end : std::min(z - rings.front(), from_end);
}

bool CylinderGrid::uniform() const
{
  const double step = 2. * PI / n_circumferential();
  for (unsigned int i = 0; i < n_circumferential(); ++i)
    if (std::abs(angles[i] - angles[0] - i * step) > 1e-9 * step)
      return false;
  return true;
}
} // namespace chaindrive::mesh
