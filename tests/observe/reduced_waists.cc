// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses at the waists of reduced links, which are added mode by mode, against those of the
// positions of their nodes: what differs is the square of strains, so that it is half as much of a
// stress at half of the amplitudes.
#include "../support/reduced.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/observe/elastic_bodies.h>

#include <algorithm>

using namespace test;

namespace
{
constexpr unsigned int n_bodies = 6;

scene::Scene make_scene()
{
  scene::Scene scene                   = empty_scene();
  const auto   chain                   = drive::make_chain(parameters::Chain());
  scene.parts[scene::Kind::inner_link] = std::make_shared<const mesh::Part>(
      mesh::make_inner_link(chain, scene.material.density, mesh::inner_link_grid(0)));
  scene.parts[scene::Kind::outer_link] = std::make_shared<const mesh::Part>(
      mesh::make_outer_link(chain, scene.material.density, mesh::outer_link_grid(0)));
  for (unsigned int k = 0; k < n_bodies; ++k)
    {
      scene::Body link      = body(scene::Motion::elastic,
                              scene::Mount::free(),
                              0.,
                              Vector3(),
                              vector(0.1 + 0.02 * k, 0.3, -0.1 * k),
                              Vector3());
      link.kind             = k % 2 == 0 ? scene::Kind::inner_link : scene::Kind::outer_link;
      link.initial.rotation = to_matrix(rotation_by(vector(0.1 * k, 0.2, 0.7 * k)));
      scene.bodies.push_back(link);
    }
  reduce(scene);
  return scene;
}

/// Each mode of each body has an energy of @p energy [J].
void excite(dynamics::System &system, const double energy)
{
  for (unsigned int g = 0; g < system.world.n_elastic_groups(); ++g)
    {
      ReducedBodies &group = reduced_group(system.world, g);
      for (unsigned int copy = 0; copy < system.world.copies[g].n_copies(); ++copy)
        for (unsigned int m = 0; m < group.n_modes(); ++m)
          group.amplitude(system.world, copy, m) =
              std::sqrt(2. * energy) * std::cos(0.3 * copy + 1.7 * m) / group.omega(m);
    }
}

/// Largest difference over the largest stress, of all bodies.
double difference(const scene::Scene &scene, const dynamics::System &system)
{
  const observe::Waists waists(scene, system);
  double                largest = 0., stress = 0.;
  for (unsigned int b = 0; b < n_bodies; ++b)
    {
      const World::Address      &place  = system.world.elastic_address[b];
      const BodyBatches         &copies = system.world.copies[place.group];
      const observe::PlateStress plates(*copies.part, copies.nodes, scene.material);
      std::vector<Vector3>       position;
      for (const unsigned int node : plates.nodes())
        position.push_back(
            system.world.group_of(place.group).position_now(system.world, place.copy, node));
      const observe::WaistStress a = waists.stress(system, b), e = plates(position);
      for (const auto value : {&observe::WaistStress::axial,
                               &observe::WaistStress::in_plane,
                               &observe::WaistStress::out_of_plane,
                               &observe::WaistStress::principal_1,
                               &observe::WaistStress::principal_2})
        {
          largest = std::max(largest, std::abs(a.*value - e.*value));
          stress  = std::max(stress, std::abs(e.*value));
        }
    }
  return largest / stress;
}
} // namespace

int main()
{
  const scene::Scene scene = make_scene();
  dynamics::System   system(scene, false);
  excite(system, 4e-8);
  const double coarse = difference(scene, system);
  excite(system, 1e-8);
  const double fine = difference(scene, system);
  verdict("squares of strains are below 1e-3 of the stress", fine < 1e-3);
  verdict("they are half as much of it at half of the amplitudes",
          std::abs(coarse / fine - 2.) < 0.1);
}
