// SPDX-License-Identifier: LGPL-2.1-or-later
// A pin pressed into a hole by the flexibilities of finite element pieces and the contact between
// them, against the closed form of conforming contact (drive/stiffness.h, another method): plane
// strain, a pin with a small bore in a thick-walled, held ring. With a wide clearance the contact
// is small, and that of Hertz' theory for a line.

#include <chaindrive/drive/stiffness.h>
#include <chaindrive/statics/flexibility.h>
#include <chaindrive/statics/pieces.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;
using namespace statics;
using dealii::Point;

namespace
{
constexpr double depth = 1e-2; // m, of the slice: long, as seen from a patch
constexpr double PI    = dealii::numbers::PI;

enum : dealii::types::boundary_id
{
  inner_side = 1,
  outer_side
};

/// A slice of a quarter y, z >= 0 of a ring; both of its ends are planes that do not bulge.
Piece slice(const double inner, const double outer, const unsigned int n_radial)
{
  dealii::Triangulation<2>         section;
  std::vector<Point<2>>            points;
  std::vector<dealii::CellData<2>> cells;
  for (unsigned int i = 0; i <= n_around / 2; ++i)
    for (unsigned int j = 0; j <= n_radial; ++j)
      {
        const double r = inner * std::pow(outer / inner, double(j) / n_radial),
                     t = 2. * PI * i / n_around;
        points.emplace_back(r * std::cos(t), i == n_around / 2 ? 0. : r * std::sin(t));
      }
  for (unsigned int i = 0; i < n_around / 2; ++i)
    for (unsigned int j = 0; j < n_radial; ++j)
      {
        const unsigned int  a = i * (n_radial + 1) + j, b = a + n_radial + 1;
        dealii::CellData<2> cell;
        cell.vertices = {a, a + 1, b, b + 1};
        cells.push_back(cell);
      }
  section.create_triangulation(points, cells, {});
  Piece piece;
  piece.mesh = std::make_unique<dealii::Triangulation<3>>();
  dealii::GridGenerator::extrude_triangulation(section, 2, depth, *piece.mesh);
  piece.mesh->set_all_manifold_ids(1);
  piece.mesh->set_manifold(1, dealii::CylindricalManifold<3>(2));
  for (const auto &face : piece.mesh->active_face_iterators())
    if (face->at_boundary())
      {
        const Point<3> &x = face->center();
        const double    r = face->vertex(0).distance(Point<3>(0., 0., face->vertex(0)[2]));
        face->set_boundary_id(std::abs(x[2]) < 1e-9 || std::abs(x[2] - depth) < 1e-9 ?
                                  unsigned(plane_z) :
                              std::abs(x[1]) < 1e-9      ? unsigned(plane_y) :
                              std::abs(r - inner) < 1e-9 ? unsigned(inner_side) :
                                                           unsigned(outer_side));
      }
  return piece;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Material  steel;
  const double    radius = 3e-3, clearance = 0.04e-3;
  const PatchGrid grid{radius, 2. * PI / n_around, 8, {0., depth}};

  Piece hole = slice(radius, 12. * radius, 8), pin = slice(0.1 * radius, radius, 6);
  hole.held = {outer_side};
  pin.free  = 0;
  const auto of_hole =
      flexibility(hole, {{inner_side, grid, Point<2>(), 0., true}}, steel, 0.01, MPI_COMM_WORLD);
  const auto of_pin =
      flexibility(pin, {{outer_side, grid, Point<2>(), 0., false}}, steel, 0.01, MPI_COMM_WORLD);

  double asymmetry = 0.;
  for (unsigned int i = 0; i < grid.n(); ++i)
    for (unsigned int j = 0; j < grid.n(); ++j)
      asymmetry = std::max(
          asymmetry, std::abs(of_pin.values(i, j) - of_pin.values(j, i)) / of_pin.values(i, i));
  std::cout << "flexibility symmetric to 1e-5: " << (asymmetry < 1e-5 ? "yes" : "NO") << '\n';

  // the same pressure on all patches of a ring held outside: Lame, in plane strain
  const double    outer = 3. * radius, ratio = outer * outer / (radius * radius);
  const PatchGrid all_round{radius, grid.width, n_around / 2, {0., depth}};
  Piece           ring = slice(radius, outer, 4);
  ring.held            = {outer_side};
  const auto of_ring   = flexibility(
      ring, {{inner_side, all_round, Point<2>(), 0., true}}, steel, 0.01, MPI_COMM_WORLD);
  const double exact =
      radius * (ratio - 1.) / (2. * (steel.lambda() + steel.mu()) + 2. * steel.mu() * ratio);
  double worst = 0.;
  for (unsigned int i = 0; i < all_round.n(); ++i)
    {
      double u = 0.;
      for (unsigned int j = 0; j < all_round.n(); ++j)
        u += of_ring.values(i, j);
      worst = std::max(worst, std::abs(u / exact - 1.));
    }
  std::cout << "ring under even pressure, each patch to 1e-3: " << (worst < 1e-3 ? "yes" : "NO")
            << '\n';

  const std::vector<CompliantPart> both = {{"hole", 0, of_hole.values}, {"pin", 0, of_pin.values}};
  const ContactProblem             problem(
      {{grid, [=](const double t) { return clearance * (1. - std::cos(t)); }}}, both, steel);
  // the four quarters of a slice make a pin of twice its depth
  for (const double q : {2e4, 1e5, 4e5, 1e6})
    {
      const ContactSolution pressed = problem.at(q * 2. * depth);
      const auto            exact   = drive::conforming_contact(radius, clearance, q, steel);
      const double peak = pressed.on_line[0] / exact.peak_pressure - 1., strip = grid.width / 8.;
      std::cout << "q " << 1e-3 * q << " N/mm: peak pressure within 4 percent: "
                << (std::abs(peak) < 0.04 ? "yes" : "NO") << ", half angle to a strip: "
                << (std::abs(pressed.half_angle[0] - exact.half_angle) < 1.2 * strip ? "yes" : "NO")
                << '\n';
    }

  // half width 2 sqrt(q R / (pi E*)), pressure 2 q / (pi times it); E* of two equal materials
  const double         wide = 1e-3, curvature_radius = radius * radius / wide;
  const ContactProblem hertz(
      {{grid, [=](const double t) { return wide * (1. - std::cos(t)); }}}, both, steel);
  for (const double q : {3e5, 1e6, 2e6})
    {
      const ContactSolution pressed = hertz.at(q * 2. * depth);
      const double half = 2. * std::sqrt(q * curvature_radius / (PI * steel.contact_modulus())),
                   peak = 2. * q / (PI * half), strip = radius * grid.width / 8.;
      std::cout << "q " << 1e-3 * q << " N/mm: Hertz' pressure to 3 percent: "
                << (std::abs(pressed.on_line[0] / peak - 1.) < 0.03 ? "yes" : "NO")
                << ", half width to a strip: "
                << (std::abs(radius * pressed.half_angle[0] - half) < 1.2 * strip ? "yes" : "NO")
                << '\n';
    }
}
