// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastostatics of pieces against closed forms, on meshes with hanging nodes: a bar in tension (any
// mesh gives the exact solution), Lame's thick-walled cylinder (order of convergence, manifolds), a
// balanced load on a piece that nothing holds. The same on any number of ranks.

#include <chaindrive/drive/chain.h>
#include <chaindrive/statics/pieces.h>

#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;
using namespace statics;
using dealii::Point;

namespace
{
const Material steel;

/// A single patch: a whole side, pushed along @p direction.
ElasticPiece::Patches
whole_side(const unsigned int                                           side,
           const std::function<dealii::Tensor<1, 3>(const Point<3> &)> &direction)
{
  return {{static_cast<dealii::types::boundary_id>(side)},
          1,
          [](const Point<3> &) { return 0U; },
          direction};
}

void bar_with_hanging_nodes()
{
  Piece piece;
  piece.mesh = std::make_unique<dealii::Triangulation<3>>();
  dealii::GridGenerator::subdivided_hyper_rectangle(
      *piece.mesh, {4, 2, 2}, Point<3>(), Point<3>(4e-3, 1e-3, 2e-3));
  for (const auto &face : piece.mesh->active_face_iterators())
    if (face->at_boundary())
      {
        face->set_boundary_id(1);
        for (unsigned int d = 0; d < 3; ++d)
          if (std::abs(face->center()[d]) < 1e-12)
            face->set_boundary_id(plane_x + d);
        if (std::abs(face->center()[0] - 4e-3) < 1e-12)
          face->set_boundary_id(2);
      }
  ElasticPiece::Refinements refinements(1);
  unsigned int              n = 0;
  for (const auto &cell : piece.mesh->active_cell_iterators())
    if (++n % 3 == 0)
      refinements[0].insert(cell->id());
  ElasticPiece       bar(piece, steel, MPI_COMM_WORLD, refinements);
  const auto         load  = bar.loads(whole_side(2, [](const Point<3> &) {
    dealii::Tensor<1, 3> x;
    x[0] = 1.;
    return x;
  }))[0];
  const double       exact = 4e-3 / (2e-6 * steel.youngs_modulus);
  std::ostringstream text;
  text << bar.n_cells() << " cells, extension over the exact one: " << std::fixed
       << std::setprecision(5) << bar.displacement(bar.solve(load), load) / exact << '\n';
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << "bar: " << text.str();
}

/// Pressure in the bore of a roller with free ends: plane stress, u(a) = p a / E ((b^2 + a^2)/(b^2
/// - a^2) + nu) (Timoshenko and Goodier, Theory of Elasticity, 28).
void thick_walled_cylinder()
{
  const auto   chain = drive::make_chain(parameters::Chain());
  const Piece  piece = roller_quarter(chain);
  const double a = 0.5 * chain.roller_bore, b = 0.5 * chain.roller_diameter;
  const double exact =
      a / steel.youngs_modulus * ((b * b + a * a) / (b * b - a * a) + steel.poissons_ratio);
  ElasticPiece::Refinements refinements;
  double                    before = 0.;
  for (unsigned int level = 0; level < 3; ++level)
    {
      ElasticPiece ring(piece, steel, MPI_COMM_WORLD, refinements);
      const auto   load  = ring.loads(whole_side(mesh::roller_bore, [](const Point<3> &x) {
        dealii::Tensor<1, 3> r;
        r[0] = x[0];
        r[1] = x[1];
        return r / r.norm();
      }))[0];
      const auto   u     = ring.solve(load);
      const double error = std::abs(ring.displacement(u, load) * ring.areas()[0] / exact - 1.);
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << "cylinder: " << ring.n_cells()
                  << " cells, error below 2e-3: " << (error < 2e-3 ? "yes" : "NO")
                  << ", an eighth of the last or less: "
                  << (level == 0 || error < before / 8. || error < 1e-6 ? "yes" : "NO") << '\n';
      before = error;
      refinements.push_back(ring.worst_cells(u, 1.));
    }
}

/// A roller that is pushed at one side accelerates; its centre of mass does not move.
void free_piece()
{
  const auto   chain = drive::make_chain(parameters::Chain());
  const Piece  piece = roller_quarter(chain);
  ElasticPiece ring(piece, steel, MPI_COMM_WORLD);
  const auto   push = [](const double from, const double to) {
    return ElasticPiece::Patches{{mesh::roller_outside},
                                 1,
                                 [=](const Point<3> &x) {
                                   const double angle = std::atan2(x[1], x[0]);
                                   return angle >= from && angle < to ? 0U :
                                                                          ElasticPiece::Patches::none;
                                 },
                                 [](const Point<3> &x) {
                                   dealii::Tensor<1, 3> r;
                                   r[0] = -x[0];
                                   r[1] = -x[1];
                                   return r / r.norm();
                                 }};
  };
  const double width = 2. * dealii::numbers::PI / n_around, half = dealii::numbers::PI;
  const auto   right = ring.loads(push(0., width))[0], left = ring.loads(push(half - width, 4.))[0];
  const auto   u = ring.solve(right), v = ring.solve(left);
  auto         both = right;
  both += left;
  const double one = ring.displacement(u, right), other = ring.displacement(v, left),
               across = ring.displacement(u, left), back = ring.displacement(v, right),
               pressed = ring.displacement(ring.solve(both), both);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << std::fixed << std::setprecision(4) << "ring: right and left alike " << one / other
              << ", reciprocal " << across / back << ", sum of single loads over both "
              << (one + other + across + back) / pressed << '\n';
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  bar_with_hanging_nodes();
  thick_walled_cylinder();
  free_piece();
}
