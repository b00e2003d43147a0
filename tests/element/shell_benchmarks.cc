// SPDX-License-Identifier: LGPL-2.1-or-later
// Solid-shells of which the displacement is published, on meshes of N x N elements with one through
// the wall: Scordelis and Lo's roof (0.3024), the pinched cylinder (1.8248e-5), the hemisphere with
// a hole of 18 degrees (0.0940; MacNeal and Harder 1985), the beam that is twisted by 90 degrees
// under a load in its plane and across (0.005424, 0.001754), and a square plate with clamped edges
// under a load in its middle (0.0056 P a^2 / D, Timoshenko). Displacements over those; bricks
// beside them.
#include "../support/modes.h"

#include <map>
#include <numeric>

using namespace test;
using parameters::ElementType;

namespace
{
constexpr double PI = dealii::numbers::PI;

/// A wall over the unit square: @p place gives the point of its middle surface and the unit normal.
struct Surface
{
  std::function<std::pair<Point<3>, Tensor<1, 3>>(double u, double v)> place;
  double                                                               thickness;
};

mesh::Part wall(const Surface &surface, const std::vector<unsigned int> &cells)
{
  return part([&](dealii::Triangulation<3> &mesh) {
    dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh, {cells[0], cells[1], 1}, Point<3>(), Point<3>(1., 1., 1.));
    dealii::GridTools::transform(
        [&](const Point<3> &x) {
          const auto [middle, normal] = surface.place(x[0], x[1]);
          return middle + (x[2] - 0.5) * surface.thickness * normal;
        },
        mesh);
  });
}

struct Case
{
  std::string                                         name;
  Surface                                             surface;
  Material                                            material;
  std::vector<unsigned int>                           cells; ///< per N
  std::function<bool(const Point<3> &, unsigned int)> held;
  /// Of a node [N] by its share and N.
  std::function<Tensor<1, 3>(const Point<3> &, double share, unsigned int n)> load;
  std::function<bool(const Point<3> &)>                                       watched;
  Tensor<1, 3>                                                                direction;
  double                                                                      expected; ///< m
};

/// Mean displacement of the watched nodes over the expected one. The share of a node is its mass
/// over that of the wall.
double displacement(const Case &c, const unsigned int n, const ElementType kind)
{
  const mesh::Part body = wall(c.surface, {n * c.cells[0], n * c.cells[1]});
  // the cells are numbered along u, then v: the axis across the wall is found by its normal
  std::map<std::array<long, 3>, Tensor<1, 3>> normals;
  const auto                                  key = [](const Point<3> &x) {
    return std::array<long, 3>{
        {std::lround(x[0] * 1e6), std::lround(x[1] * 1e6), std::lround(x[2] * 1e6)}};
  };
  for (const auto &cell : body.mesh->active_cell_iterators())
    {
      Tensor<1, 3> through;
      for (unsigned int v = 0; v < 4; ++v)
        through += cell->vertex(v + 4) - cell->vertex(v);
      normals[key(cell->center())] = through;
    }
  element::Selection selection;
  selection.element_type = kind;
  selection.across       = [&](const Point<3> &x) { return normals.at(key(x)); };
  const Hexahedra reference(
      body, c.material, Formulation::enhanced, 0.1, element::Shape::symmetric_prism, selection);
  LinearModel model(reference);
  model.constrain(reference, c.held);

  const double   mass = std::accumulate(reference.mass.begin(), reference.mass.end(), 0.);
  Vector<double> force(model.stiffness.m());
  unsigned int   n_watched = 0;
  for (unsigned int node = 0; node < reference.n_nodes(); ++node)
    {
      const Tensor<1, 3> f = c.load(reference.position[node], reference.mass[node] / mass, n);
      for (unsigned int i = 0; i < 3; ++i)
        if (!c.held(reference.position[node], i))
          force[3 * node + i] = f[i];
    }
  const Vector<double> u   = model.displacements(force);
  double               sum = 0.;
  for (unsigned int node = 0; node < reference.n_nodes(); ++node)
    if (c.watched(reference.position[node]))
      {
        ++n_watched;
        for (unsigned int i = 0; i < 3; ++i)
          sum += c.direction[i] * u[3 * node + i];
      }
  return sum / n_watched / c.expected;
}

Tensor<1, 3> vector(const double x, const double y, const double z) { return Point<3>(x, y, z); }

Material material_of(const double E, const double nu)
{
  Material material;
  material.youngs_modulus = E;
  material.poissons_ratio = nu;
  return material;
}

bool zero(const double x) { return std::abs(x) < 1e-9; }

/// A quarter: x along the roof, y up, z towards the free edge; the crown at z = 0.
Case roof()
{
  const double R = 25., L = 50., open = 40. * PI / 180., t = 0.25;
  return {"roof",
          {[=](const double u, const double v) {
             const Tensor<1, 3> n = vector(0., std::cos(u * open), std::sin(u * open));
             return std::make_pair(Point<3>(0.5 * L * v, 0., 0.) + R * n, n);
           },
           t},
          material_of(4.32e8, 0.),
          {1, 1},
          [=](const Point<3> &x, const unsigned int i) { // symmetry; diaphragm at the end
            return (i == 0 && zero(x[0])) || (i == 2 && zero(x[2])) ||
                   (i != 0 && zero(x[0] - 0.5 * L));
          },
          [=](const Point<3> &, const double share, unsigned int) {
            return vector(0., -90. * 0.5 * L * R * open * share, 0.);
          },
          [=](const Point<3> &x) { // the middle of the free edge, both faces
            return zero(x[0]) && std::atan2(x[2], x[1]) > open - 1e-9;
          },
          vector(0., -1., 0.),
          0.3024};
}

/// An eighth of a cylinder along x between diaphragms, pinched at y = R, x = 0.
Case cylinder()
{
  const double R = 300., L = 600., t = 3.;
  return {"cylinder",
          {[=](const double u, const double v) {
             const Tensor<1, 3> n = vector(0., std::cos(u * PI / 2.), std::sin(u * PI / 2.));
             return std::make_pair(Point<3>(0.5 * L * v, 0., 0.) + R * n, n);
           },
           t},
          material_of(3e6, 0.3),
          {1, 1},
          [=](const Point<3> &x, const unsigned int i) {
            return (i == 0 && zero(x[0])) || (i == 1 && std::abs(x[1]) < 1e-6) ||
                   (i == 2 && zero(x[2])) || (i != 0 && zero(x[0] - 0.5 * L));
          },
          [=](const Point<3> &x, double, unsigned int) { // a quarter of the force on both faces
            return zero(x[0]) && zero(x[2]) ? vector(0., -0.125, 0.) : vector(0., 0., 0.);
          },
          [=](const Point<3> &x) { return zero(x[0]) && zero(x[2]); },
          vector(0., -1., 0.),
          1.8248e-5};
}

/// A quarter of a hemisphere about z with a hole of 18 degrees: pulled along x, pushed along y.
Case hemisphere()
{
  const double R = 10., t = 0.04;
  return {"hemisphere",
          {[=](const double u, const double v) {
             const double       rise = v * 72. * PI / 180., turn = u * PI / 2.;
             const Tensor<1, 3> n = vector(
                 std::cos(rise) * std::cos(turn), std::cos(rise) * std::sin(turn), std::sin(rise));
             return std::make_pair(Point<3>() + R * n, n);
           },
           t},
          material_of(6.825e7, 0.3),
          {1, 1},
          [=](const Point<3> &x, const unsigned int i) {
            return (i == 1 && std::abs(x[1]) < 1e-9) || (i == 0 && std::abs(x[0]) < 1e-9) ||
                   (i == 2 && zero(x[2]) && std::abs(x[1]) < 1e-9 &&
                    x[0] > R); // one face: it may turn
          },
          [=](const Point<3> &x, double, unsigned int) { // half of the force of 2 on both faces
            return zero(x[2]) && std::abs(x[1]) < 1e-9 ? vector(0.5, 0., 0.) :
                   zero(x[2]) && std::abs(x[0]) < 1e-9 ? vector(0., -0.5, 0.) :
                                                         vector(0., 0., 0.);
          },
          [=](const Point<3> &x) { return zero(x[2]) && std::abs(x[1]) < 1e-9; },
          vector(1., 0., 0.),
          0.0940};
}

/// Along x; its section turns from y to z.
Case twisted_beam(const bool in_plane)
{
  const double L = 12., width = 1.1, t = 0.32;
  return {in_plane ? "twisted beam, in plane" : "twisted beam, across",
          {[=](const double u, const double v) {
             const double turn = u * PI / 2.;
             return std::make_pair(Point<3>(L * u,
                                            width * (v - 0.5) * std::cos(turn),
                                            width * (v - 0.5) * std::sin(turn)),
                                   vector(0., -std::sin(turn), std::cos(turn)));
           },
           t},
          material_of(29e6, 0.22),
          {6, 1},
          [=](const Point<3> &x, unsigned int) { return zero(x[0]); },
          [=](const Point<3> &x, const double share, const unsigned int n) {
            // the section at the end has half of the mass of its cells, one of 6 N
            const double at_end = zero(x[0] - L) ? 12. * n * share : 0.;
            return in_plane ? vector(0., 0., at_end) : vector(0., at_end, 0.);
          },
          [=](const Point<3> &x) { return zero(x[0] - L); },
          in_plane ? vector(0., 0., 1.) : vector(0., 1., 0.),
          in_plane ? 0.005424 : 0.001754};
}

/// A quarter of a plate of 2 x 2 m, 10 mm thick, its middle at the origin.
Case plate()
{
  const double a = 2., t = 0.01, E = 210e9, nu = 0.3, P = 1000.;
  const double D = E * t * t * t / (12. * (1. - nu * nu));
  return {"clamped plate",
          {[=](const double u, const double v) {
             return std::make_pair(Point<3>(0.5 * a * u, 0.5 * a * v, 0.), vector(0., 0., 1.));
           },
           t},
          material_of(E, nu),
          {1, 1},
          [=](const Point<3> &x, const unsigned int i) {
            return zero(x[0] - 0.5 * a) || zero(x[1] - 0.5 * a) || (i == 0 && zero(x[0])) ||
                   (i == 1 && zero(x[1]));
          },
          [=](const Point<3> &x, double, unsigned int) {
            return zero(x[0]) && zero(x[1]) ? vector(0., 0., 0.125 * P) : vector(0., 0., 0.);
          },
          [=](const Point<3> &x) { return zero(x[0]) && zero(x[1]); },
          vector(0., 0., 1.),
          0.0056 * P * a * a / D};
}
} // namespace

int main()
{
  std::cout << std::fixed << std::setprecision(3);
  for (Case c :
       {roof(), cylinder(), hemisphere(), twisted_beam(true), twisted_beam(false), plate()})
    {
      for (const auto &[kind, name] :
           {std::pair<ElementType, const char *>{ElementType::solid_shell, "solid-shell"},
            {ElementType::solid, "solid"}})
        {
          std::cout << c.name << ", " << name << ':';
          for (const unsigned int n : c.cells[0] > 1 ? std::vector<unsigned int>{1, 2, 4} :
                                                       std::vector<unsigned int>{4, 8, 16})
            std::cout << ' ' << displacement(c, n, kind);
          std::cout << '\n';
        }
    }
  // 0.83 and 0.96 with as many four-node shells with rotations (Dvorkin and Bathe 1984, table 6)
  std::cout << "cylinder, 10 x 10 and 20 x 20 solid-shells: "
            << displacement(cylinder(), 10, ElementType::solid_shell) << ' '
            << displacement(cylinder(), 20, ElementType::solid_shell) << '\n';
}
