// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/generate/sweep.h>
#include <chaindrive/mesh/mass.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::mesh
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
constexpr unsigned int n_levels = 5;

/// A point at the polar angle 2 pi i / n; n a multiple of four. Mirror images are exact.
Point<2> on_circle(const double radius, const unsigned int i, const unsigned int n)
{
  if (4 * i == n || 4 * i == 3 * n)
    return {0., 4 * i == n ? radius : -radius};
  if (2 * i > n)
    {
      const Point<2> mirror = on_circle(radius, n - i, n);
      return {mirror[0], -mirror[1]};
    }
  if (4 * i > n)
    {
      const Point<2> mirror = on_circle(radius, n / 2 - i, n);
      return {-mirror[0], mirror[1]};
    }
  const double angle = 2. * PI * i / n;
  return {radius * std::cos(angle), i == 0 ? 0. : radius * std::sin(angle)};
}

using Ring = std::vector<unsigned int>;

/// Point of the outline of the right half of a plate, its edge x = 0 at mid-pitch included, at the
/// polar angle @p phi, 0 <= phi <= pi, about the hole.
Point<2> outline_of_half(const drive::Plate &plate, const double corner, const double phi)
{
  const double x = 0.5 * plate.hole_pitch, r = 0.5 * plate.height, w = 0.5 * plate.waist;
  const double c = std::cos(phi), s = phi == PI ? 0. : std::sin(phi);
  if (phi > corner - 1e-12)
    return {0., -x / c * s};
  double t = r;
  if (phi > PI - plate.tangency_angle())
    {
      if (plate.has_waist())
        {
          // first intersection with the waist's circle about (0, w + R)
          const double radius = plate.waist_radius();
          const double b      = -x * c + (w + radius) * s;
          t = b - std::sqrt(std::max(0., b * b - (x * x + w * (w + 2. * radius))));
        }
      else
        t = w / s;
    }
  return {x + t * c, t * s};
}

struct LinkDimensions
{
  drive::Plate plate;
  double       diameter, bore, length; ///< of bush or pin
  Component    plate_id, tube_id;
};

/// Adds what lies inside of @p ring, whose points are on a circle about @p centre: a tube down to
/// the bore or, without one, a few rings about a square of rounded sides.
void add_tube(PlanarMesh        &section,
              const Ring        &ring,
              const Point<2>    &centre,
              const double       bore,
              const unsigned int n_rings,
              const Component    component)
{
  const unsigned int n      = static_cast<unsigned int>(ring.size());
  const double       radius = section.points[ring[0]].distance(centre);

  // where point i of the innermost ring lies between centre and circle
  const auto inner = [&](const unsigned int i) {
    if (bore > 0.)
      return 0.5 * bore / radius;
    const Tensor<1, 2> e = (section.points[ring[i]] - centre) / radius;
    return 0.5 * (0.55 + 0.55 * std::sqrt(0.5) / std::max(std::abs(e[0]), std::abs(e[1])));
  };
  std::vector<Ring> rings = {ring};
  for (unsigned int j = 1; j <= n_rings; ++j)
    {
      Ring next(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          const double s = 1. + (inner(i) - 1.) * j / n_rings;
          next[i]        = section.add(centre + s * (section.points[ring[i]] - centre));
        }
      rings.push_back(next);
    }
  section.add_grid(rings, component, true);
  if (bore > 0.)
    return;

  // The square: its corners are the points at 45 degrees, its rows run with falling y.
  const unsigned int m = n / 4, first = n / 8;
  const Ring        &round = rings.back();
  const auto         side  = [&](const unsigned int start, const int step) {
    Line line;
    for (unsigned int i = 0; i <= m; ++i)
      line.push_back(section.points[round[(start + n + step * int(i)) % n]]);
    return line;
  };
  // the upper row goes from left to right, the left column downwards
  const unsigned int left = first + m;
  const Grid         grid = fill(side(left, -1), side(left + m, 1), side(left, 1), side(first, -1));
  std::vector<Ring>  rows(m + 1, Ring(m + 1));
  for (unsigned int j = 0; j <= m; ++j)
    for (unsigned int i = 0; i <= m; ++i)
      rows[j][i] = j == 0 ? round[(left + n - i) % n] :
                   j == m ? round[(left + m + i) % n] :
                   i == 0 ? round[(left + j) % n] :
                   i == m ? round[(first + n - j) % n] :
                            section.add(grid[j][i]);
  // to the left of a row that runs to the right is the row above
  std::reverse(rows.begin(), rows.end());
  section.add_grid(rows, component, false);
}

PlanarMesh link_section(const LinkDimensions &dimensions, const LinkGrid &grid)
{
  const unsigned int n = grid.around, half = n / 2;
  PlanarMesh         section;

  // The outline's points: equal angles, but the corner at mid-pitch takes the nearest of them.
  const double corner_angle = std::atan2(dimensions.plate.waist, -dimensions.plate.hole_pitch);
  const unsigned int corner =
      std::min(static_cast<unsigned int>(std::lround(corner_angle / (2. * PI / n))), half - 1);
  std::vector<Point<2>> outline(n);
  for (unsigned int i = 0; i <= half; ++i)
    {
      double phi = i <= corner ?
                       corner_angle * i / corner :
                       corner_angle + (PI - corner_angle) * (i - corner) / (half - corner);
      if (2 * i == n)
        phi = PI;
      outline[i] = outline_of_half(dimensions.plate, corner_angle, phi);
      if (i > 0 && 2 * i < n)
        outline[n - i] = {outline[i][0], -outline[i][1]};
    }

  // Right half, then the left half: the right one turned by 180 degrees about the origin.
  Ring shared(n, 0);
  for (const double side : {1., -1.})
    {
      const auto place = [side](const Point<2> &p) { return Point<2>(side * p[0], side * p[1]); };
      const Point<2> hole(0.5 * dimensions.plate.hole_pitch, 0.);

      std::vector<Ring> rings; // from outside in
      for (unsigned int j = 0; j <= grid.rings; ++j)
        {
          const double s = double(j) / grid.rings;
          Ring         ring(n);
          for (unsigned int i = 0; i < n; ++i)
            {
              const Point<2> inner = hole + on_circle(0.5 * dimensions.diameter, i, n);
              const Point<2> p     = j == 0 ? outline[i] : outline[i] + s * (inner - outline[i]);
              if (j == 0 && side < 0. && i >= corner && i <= n - corner)
                ring[i] = shared[n - i];
              else
                ring[i] = section.add(place(j == grid.rings ? inner : p));
            }
          rings.push_back(ring);
        }
      if (side > 0.)
        shared = rings.front();
      section.add_grid(rings, dimensions.plate_id, true);

      add_tube(section, rings.back(), place(hole), dimensions.bore, grid.wall, dimensions.tube_id);
    }
  return section;
}

/// Between the inner faces of the plates.
std::vector<double> planes_between_plates(const double inner_face, const LinkGrid &grid)
{
  const unsigned int n = grid.along / 2;
  if (grid.bearing_end == 0. || n < 2)
    return planes_of(inner_face, grid.along, grid.half);
  std::vector<double> upper = divide(0., grid.bearing_end, n - 1);
  upper.push_back(inner_face);
  if (grid.half)
    return upper;
  std::vector<double> planes;
  for (unsigned int i = n; i > 0; --i)
    planes.push_back(-upper[i]);
  planes.insert(planes.end(), upper.begin(), upper.end());
  return planes;
}

Part make_link(const std::string &name, const LinkDimensions &dimensions, LinkGrid grid)
{
  if (dimensions.bore == 0.) // the square inside has its corners at 45 degrees
    grid.around = (grid.around + 7) / 8 * 8;

  const double inner_face = 0.5 * (dimensions.length - dimensions.plate.thickness),
               outer_face = 0.5 * (dimensions.length + dimensions.plate.thickness);
  std::vector<double> planes;
  if (!grid.half)
    {
      planes = divide(-outer_face, -inner_face, grid.plate_layers);
      planes.pop_back();
    }
  for (const double z : planes_between_plates(inner_face, grid))
    planes.push_back(z);
  planes.pop_back();
  for (const double z : divide(inner_face, outer_face, grid.plate_layers))
    planes.push_back(z);

  const auto present = [&](const Component c, const unsigned int layer) {
    return c == dimensions.tube_id || std::abs(planes[layer] + planes[layer + 1]) > 2. * inner_face;
  };
  const auto surface_of = [&](const Component c, const Point<3> &centre, const bool end_face) {
    if (c == dimensions.plate_id)
      {
        if (!end_face)
          return plate_edges;
        return std::abs(centre[2]) > 0.5 * dimensions.length ? plate_outer_faces :
                                                               plate_inner_faces;
      }
    if (end_face)
      return centre[2] == 0. ? middle_plane : other_surface;
    const bool   second = centre[0] > 0.;
    const double r = std::hypot(std::abs(centre[0]) - 0.5 * dimensions.plate.hole_pitch, centre[1]);
    if (r > 0.25 * (dimensions.diameter + dimensions.bore))
      {
        if (c == bush)
          return second ? bush_outside_second : bush_outside_first;
        return second ? pin_outside_second : pin_outside_first;
      }
    if (c == bush)
      return second ? bush_bore_second : bush_bore_first;
    return pin_bore;
  };

  Part part;
  part.name = name;
  part.half = grid.half;
  part.mesh = sweep(link_section(dimensions, grid), planes, present, surface_of);
  return part;
}
} // namespace

RollerGrid::RollerGrid(const unsigned int refinement)
{
  constexpr unsigned int table[n_levels][3] = {
      {1, 24, 2}, {1, 24, 4}, {2, 32, 6}, {3, 48, 10}, {4, 64, 14}};
  const auto &row = table[std::min(refinement, n_levels - 1)];
  wall            = row[0];
  around          = row[1];
  along           = row[2];
}

LinkGrid inner_link_grid(const unsigned int refinement)
{
  constexpr LinkGrid table[n_levels] = {
      {20, 1, 1, 1, 4}, {24, 1, 2, 1, 4}, {32, 1, 3, 2, 6}, {40, 2, 4, 2, 10}, {56, 3, 6, 4, 14}};
  return table[std::min(refinement, n_levels - 1)];
}

LinkGrid outer_link_grid(const unsigned int refinement)
{
  constexpr LinkGrid table[n_levels] = {
      {16, 1, 1, 1, 4}, {16, 1, 2, 1, 6}, {20, 1, 3, 2, 8}, {24, 2, 4, 2, 14}, {36, 3, 6, 4, 20}};
  return table[std::min(refinement, n_levels - 1)];
}

Part make_roller(const drive::ChainDimensions &chain, const double density, const RollerGrid &grid)
{
  PlanarMesh section;
  Ring       outside(grid.around);
  for (unsigned int i = 0; i < grid.around; ++i)
    outside[i] = section.add(on_circle(0.5 * chain.roller_diameter, i, grid.around));
  add_tube(section, outside, Point<2>(), chain.roller_bore, grid.wall, roller);

  const double middle     = 0.25 * (chain.roller_diameter + chain.roller_bore);
  const auto   surface_of = [middle](Component, const Point<3> &centre, const bool end_face) {
    if (end_face)
      return centre[2] == 0. ? middle_plane : roller_ends;
    return std::hypot(centre[0], centre[1]) > middle ? roller_outside : roller_bore;
  };

  Part part;
  part.name    = "roller";
  part.density = density;
  part.half    = grid.half;
  part.mesh    = sweep(
      section,
      planes_of(0.5 * chain.roller_length, grid.along, grid.half),
      [](Component, unsigned int) { return true; },
      surface_of);
  part.exact = drive::roller_solid(chain, density);

  std::array<double, n_components> masses{};
  masses[roller] = part.exact.mass;
  match_masses(part, masses);
  return part;
}

Part make_inner_link(const drive::ChainDimensions &chain,
                     const double                  density,
                     const LinkGrid               &grid)
{
  const drive::Plate plate = drive::inner_plate(chain);

  Part part =
      make_link("inner link",
                {plate, chain.bush_diameter, chain.bush_bore, chain.bush_length, inner_plate, bush},
                grid);
  part.exact = drive::inner_link_solid(chain, density);

  std::array<double, n_components> masses{};
  masses[inner_plate] = 2. * drive::plate_solid(plate, chain.link_density_factor * density).mass;
  masses[bush]        = 2. * drive::bush_solid(chain, density).mass;
  part.density        = density;
  match_masses(part, masses);
  return part;
}

Part make_outer_link(const drive::ChainDimensions &chain,
                     const double                  density,
                     const LinkGrid               &grid)
{
  const drive::Plate plate = drive::outer_plate(chain);

  Part part =
      make_link("outer link",
                {plate, chain.pin_diameter, chain.pin_bore, chain.pin_length, outer_plate, pin},
                grid);
  part.exact = drive::outer_link_solid(chain, density);

  std::array<double, n_components> masses{};
  masses[outer_plate] = 2. * drive::plate_solid(plate, chain.link_density_factor * density).mass;
  masses[pin]         = 2. * drive::pin_solid(chain, density).mass;
  part.density        = density;
  match_masses(part, masses);
  return part;
}
} // namespace chaindrive::mesh
