// SPDX-License-Identifier: LGPL-2.1-or-later
// The ladder of fidelities: two links that are pulled, as simple and layered models take their
// stiffness from room statics, and as the full model has them on meshes of its own, with its
// elements and its penalty contact. The middle plane of the inner link is held, that of the outer
// one is moved by the extension that statics gives for a load; the force is compared.
#include "../support/joint_statics.h"

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

/// The force [N] that pulls the joint of two links meshed at level @p refinement when they are
/// longer by @p extension [m] per pitch.
double full_force(const drive::ChainDimensions &chain,
                  const unsigned int            refinement,
                  const double                  factor,
                  const double                  extension)
{
  const mesh::Part inner_part = mesh::make_inner_link(
                       chain, material.density, mesh::inner_link_grid(refinement)),
                   outer_part = mesh::make_outer_link(
                       chain, material.density, mesh::outer_link_grid(refinement));
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
  Statics    &statics = joint.statics;
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
  return joint.force();
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int levels = argc > 1 ? std::stoul(argv[1]) : 2; // that of full.prm is 1

  const auto       chain = drive::make_chain(parameters::Chain());
  statics::Library library(material, statics::Cache::usual_folder(), MPI_COMM_WORLD);
  const auto       pull = [&](const double load) {
    return statics::at_force([&](const unsigned int n) { return library.pulled_links(chain, n); },
                             load)
        .approach[0];
  };
  for (const double load : {100., 300., 1000., 1412., 3000.})
    std::cout << "per pitch at " << int(load) << " N: " << std::setprecision(3)
              << 1e-6 * load / pull(load) << " kN/mm\n";

  for (unsigned int level = levels - 1; level < levels; ++level)
    for (const double load : {500., 1412.})
      for (const double factor : {0.5, 5.})
        std::cout << "full, level " << level << ", penalty factor " << factor << ", " << int(load)
                  << " N: force over that of statics " << std::fixed << std::setprecision(2)
                  << full_force(chain, level, factor, pull(load)) / load << std::defaultfloat
                  << '\n';
}
