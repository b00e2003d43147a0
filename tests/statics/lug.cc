// SPDX-License-Identifier: LGPL-2.1-or-later
// Plates that pins pull by their holes. A straight plate, five times as wide as its hole and as
// thick as its radius, under a pressure like a cosine: by two pins against each other the largest
// stress is 1.748 P / 2 r t, in the middle of the thickness (Shivakumar and Newman, NASA TP-3192,
// 1992, their equation for wedge loading, which is known to 2 %). One pin makes half of that and of
// what remote tension does, 3.196 r / w, on the middle of the edge, and a little more nearer to the
// pin. Then the plates of chains: the dynamic strengths of ISO 606 are the same stress at the hole.

#include <chaindrive/drive/catalogue.h>
#include <chaindrive/drive/life.h>
#include <chaindrive/statics/library.h>
#include <chaindrive/statics/peak_stress.h>
#include <chaindrive/statics/pieces.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace chaindrive;
using namespace statics;
using dealii::Point;

namespace
{
constexpr double radius = 1e-3, half_width = 5e-3, reach = 15e-3, half_depth = 0.5e-3; // m

/// The half y > 0 of the plate and of its thickness, which symmetry holds at its far end; or of
/// that what is at x > 0, which symmetry holds below the hole.
Piece plate(const bool quarter)
{
  dealii::Triangulation<2> square, flat, half, ahead, behind, all;
  dealii::GridGenerator::hyper_cube_with_cylindrical_hole(square, radius, half_width);
  square.refine_global(2);
  dealii::GridGenerator::flatten_triangulation(square, flat);
  std::set<dealii::Triangulation<2>::active_cell_iterator> below;
  for (const auto &cell : flat.active_cell_iterators())
    if (cell->center()[1] < 0. || (quarter && cell->center()[0] < 0.))
      below.insert(cell);
  dealii::GridGenerator::create_triangulation_with_removed_cells(flat, below, half);
  dealii::GridGenerator::subdivided_hyper_rectangle(
      ahead, {5, 4}, Point<2>(half_width, 0.), Point<2>(reach, half_width));
  dealii::GridGenerator::subdivided_hyper_rectangle(
      behind, {5, 4}, Point<2>(-reach, 0.), Point<2>(-half_width, half_width));
  if (quarter)
    dealii::GridGenerator::merge_triangulations(half, ahead, all, 1e-9);
  else
    dealii::GridGenerator::merge_triangulations({&half, &ahead, &behind}, all, 1e-9);
  Piece piece;
  piece.mesh = std::make_unique<dealii::Triangulation<3>>();
  dealii::GridGenerator::extrude_triangulation(all, 2, half_depth, *piece.mesh);
  piece.mesh->set_manifold(1, dealii::CylindricalManifold<3>(2));
  for (const auto &cell : piece.mesh->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        {
          const auto     face = cell->face(f);
          const Point<3> x    = face->center();
          const auto     is = [](const double a, const double b) { return std::abs(a - b) < 1e-9; };
          face->set_boundary_id(mesh::other_surface);
          if (is(x[2], 0.))
            face->set_boundary_id(plane_z);
          else if (is(x[0], quarter ? 0. : reach))
            face->set_boundary_id(plane_x);
          else if (is(x[1], 0.))
            face->set_boundary_id(plane_y);
          else if (std::hypot(x[0], x[1]) < 1.5 * radius && !is(x[2], half_depth))
            {
              face->set_boundary_id(hole_side);
              face->set_all_manifold_ids(1);
            }
        }
  return piece;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Material                                 steel;

  const auto factor_of = [&steel](const bool wedge) {
    const ElasticPiece::Patches pressure{{hole_side},
                                         1,
                                         [wedge](const Point<3> &x) {
                                           return (x[0] > 0.) == wedge ?
                                                      0U :
                                                      ElasticPiece::Patches::none;
                                         },
                                         [](const Point<3> &x) {
                                           dealii::Tensor<1, 3> r;
                                           r[0] = x[0];
                                           r[1] = x[1];
                                           return 2. * std::abs(r[0]) / r.norm_square() * r;
                                         }};
    // a newton on a quarter of what a pin bears
    return radius * half_depth *
           peak_stress(plate(wedge), pressure, hole_side, steel, 0.03, MPI_COMM_WORLD).per_force;
  };
  const double wedge = factor_of(true), pin = factor_of(false), middle = 0.5 * (1.748 + 3.196 / 5.);
  std::cout << "two pins: 1.748 to 3 percent "
            << (std::abs(wedge / 1.748 - 1.) < 0.03 ? "yes" : "NO")
            << "\none pin: as on the middle of the edge or up to 8 percent more "
            << (pin > 0.99 * middle && pin < 1.08 * middle ? "yes" : "NO") << '\n';

  Library library(steel, "", MPI_COMM_SELF);
  for (const char *designation : {"08A", "40A"})
    {
      parameters::Chain given;
      given.designation                  = designation;
      const drive::ChainDimensions chain = drive::make_chain(given);
      double                       most  = 0.;
      for (const bool inner : {true, false})
        {
          const drive::Plate plate  = inner ? drive::inner_plate(chain) : drive::outer_plate(chain);
          const double       net    = (plate.height - plate.hole_diameter) * plate.thickness;
          const double       factor = 0.25 * net * library.pulled_plate(chain, inner).per_force;
          most                      = std::max(most,
                          drive::plate_stress(*drive::minimum_dynamic_strength(designation),
                                              plate.height,
                                              chain.waist_ratio * plate.height,
                                              plate.hole_diameter,
                                              plate.thickness,
                                              factor)
                              .hole);
        }
      std::cout << designation << ": dynamic strength by the stress at the hole to 5 percent "
                << (std::abs(most / drive::hole_strength(chain.pitch) - 1.) < 0.05 ? "yes" : "NO")
                << '\n';
    }
}
