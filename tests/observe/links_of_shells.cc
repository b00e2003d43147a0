// SPDX-License-Identifier: LGPL-2.1-or-later
// Links of solid elements, of solid-shells and of membranes on the mesh of prm/paper/full-shell.prm
// and on finer ones, pulled by a pressure like the cosine of the angle on the far half of
//
//   bushes' bores where a pin bears, within the thickness of the plates,
//   bushes' outsides where a roller bears, between the plates,
//   pins where a bush bears.
//
// Their stiffness, force over the displacement in its sense, over that of quadratic elements on
// meshes that are refined where they are in error until the last refinement changes it by less than
// one percent. Stresses at the waist are over those of the pull. Two links in contact are in the
// test statics/ladder.
#include "../support/links.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/plate.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/observe/plate_stress.h>
#include <chaindrive/statics/pieces.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

using namespace test;

namespace
{
const parameters::Material material;

/// Where a link is pulled.
struct Pull
{
  std::string                    name;
  bool                           inner;
  mesh::Surface                  first, second; ///< of the two joints
  double                         axis;          ///< distance from the middle of the link, m
  std::array<double, 2>          z;             ///< m
  statics::ElasticPiece::Patches patches;       ///< of the second joint
};

Pull pull(const std::string            &name,
          const drive::ChainDimensions &chain,
          const bool                    inner,
          const mesh::Surface           first,
          const mesh::Surface           second,
          const double                  low,
          const double                  high)
{
  const double axis = 0.5 * (inner ? chain.inner_hole_pitch : chain.outer_hole_pitch);
  // a bore is pulled from inside on its far half, an outside from the middle of the link
  const double side = second == mesh::bush_bore_second ? 1. : -1.;
  return {name,
          inner,
          first,
          second,
          axis,
          {{low, high}},
          {{second},
           1,
           [=](const Point<3> &x) {
             return side * (x[0] - axis) > 0. && x[2] > low && x[2] < high ?
                        0U :
                        statics::ElasticPiece::Patches::none;
           },
           [=](const Point<3> &x) { // like the cosine, of which the mean along x is 1/2
             Tensor<1, 3> r;
             r[0] = x[0] - axis;
             r[1] = x[1];
             return side * 2. * r[0] / r.norm_square() * r;
           }}};
}

/// N/m for the eighth of a link.
double accurate(const drive::ChainDimensions &chain, const Pull &pull)
{
  const statics::Piece               piece = statics::link_eighth(chain, pull.inner);
  statics::ElasticPiece::Refinements refinements;
  double                             before = 0.;
  for (unsigned int level = 0; level < 8; ++level)
    {
      statics::ElasticPiece part(piece, material, MPI_COMM_WORLD, refinements);
      const auto            load  = part.loads(pull.patches).front();
      const auto            u     = part.solve(load);
      const double          found = 1. / part.displacement(u, load);
      if (std::abs(found / before - 1.) < 0.01)
        return found;
      before = found;
      refinements.push_back(part.worst_cells(u, 0.3));
    }
  return 0.;
}

/// Forces on the nodes of @p part, which is pulled at both of its joints by four newtons each way
/// and both halves along z: one on each of its eighths.
Vector<double> forces(const mesh::Part &part, const mesh::Nodes &nodes, const Pull &pull)
{
  const dealii::FE_Q<3>      element(1);
  const dealii::QIterated<2> quadrature(dealii::QGauss<1>(2), 12);
  dealii::FEFaceValues<3>    values(element,
                                 quadrature,
                                 dealii::update_values | dealii::update_quadrature_points |
                                     dealii::update_JxW_values);
  Vector<double>             force(3 * nodes.size());
  double                     sum = 0.;
  for (const auto &cell : part.mesh->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      {
        const auto id = cell->face(f)->boundary_id();
        if (!cell->face(f)->at_boundary() || (id != pull.first && id != pull.second))
          continue;
        const double end = id == pull.second ? 1. : -1.;
        values.reinit(static_cast<dealii::Triangulation<3>::active_cell_iterator>(cell), f);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            Point<3> x = values.quadrature_point(q);
            x[0] *= end;
            if (pull.patches.number(x) != 0U)
              continue;
            const Tensor<1, 3> direction = pull.patches.direction(x);
            sum += values.JxW(q) * direction[0];
            for (unsigned int v = 0; v < 8; ++v)
              {
                const unsigned int node = nodes.of_vertex[cell->vertex_index(v)];
                const double       w    = values.JxW(q) * values.shape_value(v, q);
                force[3 * node] += end * w * direction[0];
                force[3 * node + 1] += w * direction[1];
              }
          }
      }
  force *= 4. / sum;
  return force;
}

struct Answer
{
  double               stiffness; ///< of an eighth, N/m
  observe::WaistStress waist;     ///< over the pull of a plate over its waist
};

Answer meshed(const drive::ChainDimensions &chain,
              const Pull                   &pull,
              const Walls                  &walls,
              const unsigned int            level)
{
  mesh::LinkGrid grid = pull.inner ? mesh::inner_link_grid(level) : mesh::outer_link_grid(level);
  grid.half           = true;
  const mesh::Part     part = pull.inner ? mesh::make_inner_link(chain, material.density, grid) :
                                           mesh::make_outer_link(chain, material.density, grid);
  const mesh::Nodes    nodes(part);
  const auto           model = link_model(part, walls);
  const Vector<double> force = forces(part, nodes, pull);
  for (unsigned int i = 0; i < force.size(); ++i)
    if (std::abs(nodes.position[i / 3][i % 3]) < 1e-9)
      model->constrain(i);
  const Vector<double> u = model->displacements(force);

  const observe::PlateStress stress(part, nodes, material);
  const double               scale = 100.; // still small
  std::vector<Tensor<1, 3>>  position;
  for (const unsigned int node : stress.nodes())
    {
      position.emplace_back(nodes.position[node]);
      for (unsigned int i = 0; i < 3; ++i)
        position.back()[i] += scale * u[3 * node + i];
    }
  const drive::Plate   plate = pull.inner ? drive::inner_plate(chain) : drive::outer_plate(chain);
  observe::WaistStress waist = stress(position);
  for (double *value : {&waist.axial, &waist.out_of_plane, &waist.principal_1, &waist.principal_2})
    *value *= plate.waist * plate.thickness / (2. * scale); // two newtons
  return {4. / (u * force), waist};
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto                                     chain = drive::make_chain(parameters::Chain());
  const double plate = chain.inner_plate_thickness, inside = 0.5 * (chain.bush_length - plate);
  const double roller       = 0.5 * chain.roller_length;
  const unsigned int levels = argc > 1 ? std::stoul(argv[1]) : 1;
  std::cout << std::fixed << std::setprecision(3);
  for (const Pull &here : {pull("inner link by its pins",
                                chain,
                                true,
                                mesh::bush_bore_first,
                                mesh::bush_bore_second,
                                inside,
                                inside + plate),
                           pull("inner link by its rollers",
                                chain,
                                true,
                                mesh::bush_outside_first,
                                mesh::bush_outside_second,
                                0.,
                                roller),
                           pull("outer link by its bushes",
                                chain,
                                false,
                                mesh::pin_outside_first,
                                mesh::pin_outside_second,
                                inside,
                                inside + plate)})
    {
      const double exact = accurate(chain, here);
      // four eighths side by side, in series with four
      std::cout << here.name << ", " << std::setprecision(0) << 2e-6 * exact << " kN/mm\n"
                << std::setprecision(3);
      for (unsigned int level = 1; level <= levels; ++level)
        for (const Walls &walls : kinds_of_walls)
          {
            const Answer found = meshed(chain, here, walls, level);
            std::cout << "  refinement " << level << ", " << walls.name << ": "
                      << found.stiffness / exact << "; waist over nominal: axial "
                      << found.waist.axial << ", principal " << found.waist.principal_1 << " and "
                      << found.waist.principal_2;
            if (walls.plates != parameters::ElementType::membrane)
              std::cout << ", out of the plane " << found.waist.out_of_plane;
            std::cout << '\n';
          }
    }
}
