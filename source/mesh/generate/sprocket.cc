// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/generate/sprocket.h>

#include <chaindrive/mesh/generate/half_profile.h>
#include <chaindrive/mesh/mass.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::mesh
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
Point<2> polar(const double r, const double angle)
{
  return {r * std::cos(angle), r * std::sin(angle)};
}

unsigned int count(const double length, const double size)
{
  return std::max(1u, static_cast<unsigned int>(std::lround(length / size)));
}

Line straight(const Point<2> &a, const Point<2> &b, const std::vector<double> &fractions)
{
  Line line;
  for (const double s : fractions)
    line.push_back(a + s * (b - a));
  return line;
}

/// A grid line from @p q, leaving in the direction @p direction, to @p h on a circle about the
/// origin, arriving along its radius: a cubic in Bezier's form at @p fractions of its parameter.
Line bent(const Point<2>            &q,
          const Tensor<1, 2>        &direction,
          const Point<2>            &h,
          const std::vector<double> &fractions)
{
  const double   handle = 0.4 * q.distance(h);
  const Point<2> b = q + handle * direction, c = h + handle / h.norm() * Tensor<1, 2>(h);
  Line           line;
  for (const double t : fractions)
    {
      const double s = 1. - t;
      line.push_back(Point<2>(s * s * s * Tensor<1, 2>(q) + 3. * s * s * t * Tensor<1, 2>(b) +
                              3. * s * t * t * Tensor<1, 2>(c) + t * t * t * Tensor<1, 2>(h)));
    }
  line.back() = h;
  return line;
}

/// Radii from @p outer down to @p inner with steps that grow from about @p size by @p ratio each.
std::vector<double>
graded(const double outer, const double inner, const double size, const double ratio)
{
  std::vector<double> steps;
  double              sum = 0.;
  for (double step = size; sum < outer - inner - 0.3 * size; step *= ratio)
    {
      steps.push_back(step);
      sum += step;
    }
  std::vector<double> radii = {outer};
  double              done  = 0.;
  for (const double step : steps)
    {
      done += step;
      radii.push_back(outer - (outer - inner) * done / sum);
    }
  radii.back() = inner;
  return radii;
}

/// The upper half of sector 0, between the middle of gap 0 and the middle of the next tooth, as a
/// planar mesh. Points on these two lines are marked.
class HalfSector
{
public:
  /// A @p picture has cells from the profile to its circle, from there to the hub and to the bore,
  /// without any between.
  HalfSector(const drive::ToothForm   &form,
             const SprocketDimensions &dimensions,
             unsigned int              refinement,
             bool                      picture);

  PlanarMesh        mesh;
  std::vector<bool> on_gap_line, on_tooth_line;

private:
  /// Numbers of the points of @p grid. Points of @p known, its row or column ends, are not
  /// repeated.
  unsigned int add(const Point<2> &p, bool gap_line, bool tooth_line);

  using Rows = std::vector<std::vector<unsigned int>>;

  /// Adds to @p rows the numbers of the points of @p line.
  void add_row(const Line &line, Rows &rows);

  /// The zone of the hub below the last of @p rows. @p circle makes the line of one of a radius.
  template <typename Circle>
  void add_hub(const Rows &rows, double hub_radius, double bore_radius, const Circle &circle);

  const bool picture_;
};

void HalfSector::add_row(const Line &line, Rows &rows)
{
  rows.emplace_back();
  for (std::size_t i = 0; i < line.size(); ++i)
    rows.back().push_back(add(line[i], i == 0, i + 1 == line.size()));
}

template <typename Circle>
void HalfSector::add_hub(const Rows   &rim_rows,
                         const double  hub_radius,
                         const double  bore_radius,
                         const Circle &circle)
{
  Rows               rows  = {rim_rows.back()};
  const double       ratio = bore_radius / hub_radius;
  const unsigned int n_hub = picture_ ? 1 : count(-std::log(ratio), 0.4);
  for (unsigned int k = 1; k <= n_hub; ++k)
    add_row(circle(k == n_hub ? bore_radius : hub_radius * std::pow(ratio, double(k) / n_hub)),
            rows);
  mesh.add_grid(rows, hub_zone, false);
}

unsigned int HalfSector::add(const Point<2> &p, const bool gap_line, const bool tooth_line)
{
  on_gap_line.push_back(gap_line);
  on_tooth_line.push_back(tooth_line);
  return mesh.add(p);
}

HalfSector::HalfSector(const drive::ToothForm   &form,
                       const SprocketDimensions &dimensions,
                       const unsigned int        refinement,
                       const bool                picture)
    : picture_(picture)
{
  const double   half_pitch_angle = PI / form.teeth;
  const Point<2> axis             = polar(1., half_pitch_angle); // middle of the tooth
  const double   pitch            = form.pitch;
  const double   root             = 0.5 * form.root_diameter;

  constexpr unsigned int n_levels            = 5;
  constexpr double       per_pitch[n_levels] = {8., 10., 14., 20., 28.};
  const double           size = pitch / per_pitch[std::min(refinement, n_levels - 1)];

  const double hub_radius = 0.5 * dimensions.hub_diameter, bore_radius = 0.5 * dimensions.bore;
  if (!(bore_radius > 0. && bore_radius < hub_radius && hub_radius < root - 0.1 * pitch))
    throw InputError("A sprocket with a bore of " + to_text(1e3 * dimensions.bore) +
                     " mm, a hub diameter of " + to_text(1e3 * dimensions.hub_diameter) +
                     " mm and a root diameter of " + to_text(2e3 * root) +
                     " mm cannot be meshed: 0 < bore < hub diameter < root diameter - 0.2 pitch is "
                     "needed.");

  const auto circle_of = [&](const double r, const unsigned int n) {
    Line line;
    for (unsigned int i = 0; i <= n; ++i)
      line.push_back(i == 0 ? Point<2>(r, 0.) :
                     i == n ? r * axis :
                              polar(r, half_pitch_angle * i / n));
    return line;
  };
  const auto radii = [&](const double outer, const double inner) {
    return picture ? std::vector<double>{outer, inner} : graded(outer, inner, size, 1.35);
  };
  if (form.flat) // rings
    {
      const unsigned int n    = count(half_pitch_angle * root, size);
      const auto         ring = [&](const double r) { return circle_of(r, n); };
      Rows               rows;
      for (const double r : radii(root, hub_radius))
        add_row(ring(r), rows);
      mesh.add_grid(rows, rim, false);
      add_hub(rows, hub_radius, bore_radius, ring);
      return;
    }

  // Where the blocks meet: tooth, rim below the tooth and rim below the seat share 180 degrees.
  const HalfProfile profile(form);
  const double      meeting = profile.where_turned_by(PI / 3. - half_pitch_angle);
  const Point<2>    q       = profile.at(meeting);
  const Point<2>    d = (Tensor<1, 2>(q) * Tensor<1, 2>(axis)) * axis; // middle of the tooth's foot
  const double      tip     = profile.tip_start();
  const unsigned int n_seat = count(meeting, size);
  // across half a tooth, which is narrow at its tip
  const unsigned int n_foot = count(0.5 * (q.distance(d) + profile.length() - tip), size);

  // profile and foot
  Line       seat   = profile.divide(0., meeting, n_seat);
  const Line flank  = profile.divide(meeting, tip, size);
  const Line land   = profile.divide(tip, profile.length(), n_foot);
  seat.front()[1]   = 0.;
  const Line foot   = straight(q, d, divide(0., 1., n_foot));
  const Line middle = straight(d, land.back(), fractions_along(flank));

  // circle below the teeth, where the transition to rings ends
  double depth = 0.35 * pitch;
  if (root - hub_radius < 1.6 * depth)
    depth = root - hub_radius;
  const double       circle  = root - depth;
  const unsigned int n_depth = picture ? 1 : count(depth, size), n_columns = n_seat + n_foot;
  const auto         arc     = [&](const double r) { return circle_of(r, n_columns); };
  const auto         part_of = [](const Line &line, unsigned int first, unsigned int last) {
    return Line(line.begin() + first, line.begin() + last + 1);
  };
  const Line         below     = arc(circle);
  const auto         fractions = divide(0., 1., n_depth);
  const Tensor<1, 2> down      = -1. * profile.tangent(meeting);
  Tensor<1, 2>       bisector  = (d - q) / d.distance(q) + down;
  bisector /= bisector.norm();
  const Line spine = bent(q, bisector, below[n_seat], fractions);

  const Grid under_seat = fill(
      seat, part_of(below, 0, n_seat), straight(seat.front(), below.front(), fractions), spine);
  const Grid under_foot =
      fill(foot, part_of(below, n_seat, n_columns), spine, straight(d, below.back(), fractions));
  const Grid tooth = fill(foot, land, flank, middle);

  // numbers, from the gap's middle to the tooth's, from the profile inwards
  std::vector<std::vector<unsigned int>> rows;
  for (unsigned int j = 0; j <= n_depth; ++j)
    {
      rows.emplace_back();
      for (unsigned int i = 0; i <= n_columns; ++i)
        rows.back().push_back(add(
            i <= n_seat ? under_seat[j][i] : under_foot[j][i - n_seat], i == 0, i == n_columns));
    }
  if (circle > hub_radius)
    {
      const std::vector<double> rings = radii(circle, hub_radius);
      for (std::size_t k = 1; k < rings.size(); ++k)
        add_row(arc(rings[k]), rows);
    }
  mesh.add_grid(rows, rim, false);

  std::vector<std::vector<unsigned int>> tooth_rows(tooth.size());
  for (std::size_t j = 0; j < tooth.size(); ++j)
    for (unsigned int i = 0; i <= n_foot; ++i)
      tooth_rows[tooth.size() - 1 - j].push_back(j == 0 ? rows[0][n_seat + i] :
                                                          add(tooth[j][i], false, i == n_foot));
  mesh.add_grid(tooth_rows, rim, false);

  add_hub(rows, hub_radius, bore_radius, arc);
}
} // namespace

PlanarMesh sprocket_section(const drive::ToothForm   &form,
                            const SprocketDimensions &dimensions,
                            const unsigned int        refinement,
                            const bool                picture)
{
  const HalfSector   half(form, dimensions, refinement, picture);
  const unsigned int n = static_cast<unsigned int>(half.mesh.points.size());
  const unsigned int z = form.teeth;

  // One sector: the upper half and its mirror image. The mirrored tooth line belongs to it, the
  // upper one to the next sector.
  constexpr unsigned int    none = dealii::numbers::invalid_unsigned_int;
  std::vector<Point<2>>     points;
  std::vector<unsigned int> upper(n, none), lower(n);
  for (unsigned int p = 0; p < n; ++p)
    {
      const Point<2> &x = half.mesh.points[p];
      if (!half.on_tooth_line[p])
        {
          upper[p] = static_cast<unsigned int>(points.size());
          points.push_back(x);
        }
      lower[p] = static_cast<unsigned int>(points.size());
      if (half.on_gap_line[p])
        lower[p] = upper[p];
      else
        points.emplace_back(x[0], -x[1]);
    }

  PlanarMesh         section;
  const unsigned int n_points = static_cast<unsigned int>(points.size());
  for (unsigned int s = 0; s < z; ++s)
    {
      const double c = std::cos(2. * PI * s / z), i = std::sin(2. * PI * s / z);
      for (const Point<2> &x : points)
        section.add(Point<2>(c * x[0] - i * x[1], i * x[0] + c * x[1]));
      for (PlanarMesh::Quad quad : half.mesh.quads)
        {
          PlanarMesh::Quad image = quad;
          for (unsigned int v = 0; v < 4; ++v)
            {
              const unsigned int p = quad.vertices[v];
              // a mirror image turns round the other way
              image.vertices[3 - v] = s * n_points + lower[p];
              quad.vertices[v] =
                  upper[p] == none ? (s + 1) % z * n_points + lower[p] : s * n_points + upper[p];
            }
          section.quads.push_back(quad);
          section.quads.push_back(image);
        }
    }
  return section;
}

Part make_sprocket(const drive::ToothForm   &form,
                   const SprocketDimensions &dimensions,
                   const double              density,
                   const unsigned int        refinement,
                   const bool                half,
                   const bool                picture)
{
  constexpr unsigned int n_levels           = 5;
  constexpr unsigned int n_layers[n_levels] = {2, 2, 4, 6, 8};
  const unsigned int     layers = !picture ? n_layers[std::min(refinement, n_levels - 1)] :
                                  half     ? 2 :
                                             1;

  const double middle     = 0.5 * (0.5 * dimensions.hub_diameter + 0.5 * dimensions.bore);
  const auto   surface_of = [middle](Component, const Point<3> &centre, const bool end_face) {
    if (end_face)
      return centre[2] == 0. ? middle_plane : sprocket_sides;
    return std::hypot(centre[0], centre[1]) > middle ? tooth_flanks : hub;
  };

  Part part;
  part.name      = "sprocket with " + std::to_string(form.teeth) + " teeth";
  part.density   = density;
  part.n_sectors = form.teeth;
  part.half      = half;
  part.mesh      = sweep(
      sprocket_section(form, dimensions, refinement, picture),
      planes_of(0.5 * dimensions.width, layers, half),
      [](Component, unsigned int) { return true; },
      surface_of);
  part.exact = drive::sprocket_solid(form, dimensions.bore, dimensions.width, density);

  std::array<double, n_components> masses{};
  masses[hub_zone] =
      drive::tube(dimensions.hub_diameter, dimensions.bore, dimensions.width, density).mass;
  masses[rim] = part.exact.mass - masses[hub_zone];
  match_masses(part, masses);
  return part;
}
} // namespace chaindrive::mesh
