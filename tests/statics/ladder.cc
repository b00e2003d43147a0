// SPDX-License-Identifier: LGPL-2.1-or-later
// The ladder of fidelities: two links that are pulled, as simple and layered models take their
// stiffness from room statics, and as the full model has them on meshes of its own, with its
// elements and its penalty contact. The middle plane x = 0 of the inner link is held, that of the
// outer one is moved by the extension that statics gives for a load; the force is compared. Links
// are pulled at both ends: of each, the quarter towards the joint with z > 0 has all there is to
// know. Once more with plates and bushes of solid-shells, and as prm/paper/full-shell.prm has them.
#include "../support/joint_statics.h"
#include "../support/links.h"

#include <chaindrive/mesh/generate/cut_out.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/statics/part_stiffness.h>

using namespace test;

namespace
{
const parameters::Material material;

/// Thickness of the elements below a side, as scene/full.cc takes it, m.
double thickness(const mesh::Part &part, const mesh::Surface side)
{
  return mesh::SurfaceNodes(part, mesh::Nodes(part), side).thickness;
}

/// The half of @p link at x > 0 or, with @p side = -1, at x < 0: the other one, which nothing
/// pulls, would hold its middle plane.
mesh::Part half_of(mesh::Part link, const double side)
{
  std::vector<unsigned int> chosen;
  for (const auto &cell : link.mesh->active_cell_iterators())
    if (side * cell->center()[0] > 0.)
      chosen.push_back(cell->active_cell_index());
  link.mesh = mesh::cut_out(
      *link.mesh, chosen, [](const mesh::CellIterator &) { return mesh::other_surface; });
  return link;
}

/// Numbers of cells of inner and outer links.
struct Grids
{
  std::string    name;
  mesh::LinkGrid inner, outer;
};

/// The force [N] that pulls the joint of two links when they are longer by @p extension [m] per
/// pitch.
double full_force(const drive::ChainDimensions &chain,
                  Grids                         grids,
                  const Walls                  &walls,
                  const double                  factor,
                  const double                  extension)
{
  grids.inner.half = grids.outer.half = true;
  const mesh::Part inner_part =
                       half_of(mesh::make_inner_link(chain, material.density, grids.inner), 1.),
                   outer_part =
                       half_of(mesh::make_outer_link(chain, material.density, grids.outer), -1.);
  Tubes inner(inner_part, mesh::bush_bore_second), outer(outer_part, mesh::pin_outside_first);
  const double inner_half = 0.5 * chain.inner_hole_pitch, outer_half = 0.5 * chain.outer_hole_pitch;
  const double at[2]    = {0., inner_half + chain.pin_clearance() + outer_half};
  Tubes       *links[2] = {&inner, &outer};
  for (unsigned int b = 0; b < 2; ++b)
    links[b]->batch.set(links[b]->batch.position, 0, [&](const Point<3> &x, unsigned int) {
      return x + vector(at[b], 0.);
    });
  const double stiffness = factor * material.bulk_modulus() /
                           std::max(thickness(inner_part, mesh::bush_bore_first),
                                    thickness(outer_part, mesh::pin_outside_first));
  JointAtRest joint(inner, outer, stiffness);
  Statics    &statics  = joint.statics;
  statics.stiffness[0] = link_model(inner_part, walls);
  statics.stiffness[1] = link_model(outer_part, walls);
  for (unsigned int b = 0; b < 2; ++b)
    for (unsigned int i = statics.first[b]; i < statics.first[b + 1]; ++i)
      {
        const unsigned int node = (i - statics.first[b]) / 3, d = (i - statics.first[b]) % 3;
        statics.held[i] = std::abs(links[b]->reference.position[node][d]) < 1e-9;
        if (b == 1 && d == 0)
          statics.u[i] = extension;
      }
  if (!joint.solve([&](const Point<3> &x) { return x[0] > inner_half; }, 1e-3))
    return 0.;
  return 2. * joint.force(); // both halves along z
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto                                     chain = drive::make_chain(parameters::Chain());
  statics::Library library(material, statics::Cache::usual_folder(), MPI_COMM_WORLD);
  const auto       pull = [&](const double load) {
    return statics::at_force([&](const unsigned int n) { return library.pulled_links(chain, n); },
                             load)
        .approach[0];
  };
  for (const double load : {100., 300., 1000., 1412., 3000.})
    std::cout << "per pitch at " << int(load) << " N: " << std::setprecision(3)
              << 1e-6 * load / pull(load) << " kN/mm\n";

  std::vector<Grids> all;
  if (argc > 1)
    {
      const auto level = static_cast<unsigned int>(std::stoul(argv[1]));
      all              = {{"refinement " + std::string(argv[1]),
                           mesh::inner_link_grid(level),
                           mesh::outer_link_grid(level)}};
    }
  else
    {
      const mesh::LinkGrid inner = mesh::inner_link_grid(1), outer = mesh::outer_link_grid(1);
      mesh::LinkGrid       along = outer, fine;
      along.along                = 12;
      fine                       = along;
      fine.around                = 24;
      fine.along                 = 20;
      all                        = {{"meshes of full.prm", inner, outer},
                                    {"12 cells along pins", inner, along},
                                    {"24 around and 20 along pins", inner, fine}};
    }
  for (const Grids &grids : all)
    for (const Walls &walls : kinds_of_walls)
      if (&grids == &all.front() || walls.plates == parameters::ElementType::solid)
        for (const double factor : {0.5, 5.})
          {
            std::cout << "full, " << grids.name
                      << (walls.plates == parameters::ElementType::solid ? "" : ", " + walls.name)
                      << ", penalty factor " << factor << ": force over that of statics"
                      << std::fixed << std::setprecision(2);
            for (const double load : {500., 1412., 3000.})
              std::cout << "  " << full_force(chain, grids, walls, factor, pull(load)) / load;
            std::cout << "  at 500, 1412, 3000 N\n" << std::defaultfloat;
          }
}
