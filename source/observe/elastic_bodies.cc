// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/reduction/static_responses.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::observe
{
namespace
{
/// The node of a roller's outside, of those next to its middle plane, that lies farthest along
/// @p direction in body axes.
unsigned int farthest_node(const BodyBatches &copies, const dealii::Tensor<1, 3> &direction)
{
  const mesh::SurfaceNodes outside(*copies.part, copies.nodes, mesh::roller_outside);
  // a millionth of the radius decides between planes
  const auto key = [&](const unsigned int node) {
    const dealii::Point<3> &x = copies.nodes.position[node];
    return 1e6 * std::abs(x[2]) - direction * x;
  };
  unsigned int best = outside.node.front();
  for (const unsigned int node : outside.node)
    if (key(node) < key(best))
      best = node;
  return best;
}

/// A small step by which nodes are moved for derivatives, m: squares of strains are lost in
/// round-off.
constexpr double small_step = 1e-8;

void add(WaistComponents &sum, const double factor, const WaistComponents &components)
{
  sum.axial += factor * components.axial;
  sum.in_plane += factor * components.in_plane;
  sum.out_of_plane += factor * components.out_of_plane;
  sum.middle += factor * components.middle;
}

/// What a unit of each amplitude of @p group does to @p plates: central differences about the
/// part at rest.
std::vector<WaistComponents>
components_of_modes(const PlateStress &plates, const BodyBatches &copies, const ModalGroup &group)
{
  std::vector<dealii::Tensor<1, 3>>              rest;
  std::vector<std::vector<dealii::Tensor<1, 3>>> motions;
  for (const unsigned int node : plates.nodes())
    {
      rest.emplace_back(copies.nodes.position[node]);
      motions.push_back(group.motions_of(node));
    }
  std::vector<WaistComponents> of_modes(group.n_modes());
  for (std::size_t m = 0; m < of_modes.size(); ++m)
    {
      double largest = 0.;
      for (const auto &of_node : motions)
        largest = std::max(largest, of_node[m].norm());
      const double h = small_step / largest; // over the motion of a unit
      for (const double sign : {1., -1.})
        {
          std::vector<dealii::Tensor<1, 3>> position = rest;
          for (std::size_t i = 0; i < position.size(); ++i)
            position[i] += sign * h * motions[i][m];
          add(of_modes[m], sign / (2. * h), plates.components(position));
        }
    }
  return of_modes;
}

/// The derivatives of the components of @p plates with respect to displacements of @p nodes, Pa/m:
/// central differences about the part at rest.
std::vector<reduction::Vector> derivatives_of(const PlateStress &plates, const mesh::Nodes &nodes)
{
  std::vector<dealii::Tensor<1, 3>> position;
  for (const unsigned int node : plates.nodes())
    position.emplace_back(nodes.position[node]);
  std::vector<reduction::Vector> derivatives(n_waist_components,
                                             reduction::Vector(3 * nodes.size()));
  for (std::size_t i = 0; i < position.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      {
        WaistComponents change{};
        for (const double sign : {1., -1.})
          {
            std::vector<dealii::Tensor<1, 3>> moved = position;
            moved[i][d] += sign * small_step;
            add(change, sign / (2. * small_step), plates.components(moved));
          }
        for (unsigned int c = 0; c < n_waist_components; ++c)
          derivatives[c][3 * plates.nodes()[i] + d] = entry(change, c);
      }
  return derivatives;
}

/// What the elastic bodies of @p group are.
scene::Kind
kind_of(const scene::Scene &scene, const dynamics::System &system, const unsigned int group)
{
  return scene.bodies[system.world.copies[group].bodies.front()].kind;
}
} // namespace

bool has_elastic(const scene::Scene             &scene,
                 const dynamics::System         &system,
                 const std::vector<scene::Kind> &kinds)
{
  for (unsigned int g = 0; g < system.world.n_elastic_groups(); ++g)
    if (std::find(kinds.begin(), kinds.end(), kind_of(scene, system, g)) != kinds.end())
      return true;
  return false;
}

double spin_of_nodes(const dynamics::System &system, const unsigned int body)
{
  const World::Address             &place  = system.world.elastic_address[body];
  const BodyBatches                &copies = system.world.copies[place.group];
  const std::vector<double>        &mass   = copies.nodes.mass;
  std::vector<dealii::Tensor<1, 3>> position, velocity;
  system.world.group_of(place.group).nodes_now(system.world, place.copy, position, velocity);
  dealii::Tensor<1, 3> centre, mean;
  for (unsigned int node = 0; node < copies.n_nodes(); ++node)
    {
      centre += mass[node] / copies.mass * position[node];
      mean += mass[node] / copies.mass * velocity[node];
    }
  double momentum = 0., inertia = 0.;
  for (unsigned int node = 0; node < copies.n_nodes(); ++node)
    {
      const dealii::Tensor<1, 3> arm = position[node] - centre, v = velocity[node] - mean;
      momentum += mass[node] * (arm[0] * v[1] - arm[1] * v[0]);
      inertia += mass[node] * (arm[0] * arm[0] + arm[1] * arm[1]);
    }
  return momentum / inertia;
}

ElasticSnapshots::ElasticSnapshots(const dynamics::System &system)
{
  for (const ElasticGroup *group : system.world.groups.elastic())
    cells_[group->copies()] = group->stress_recoveries(system.world);
}

ElasticSnapshot ElasticSnapshots::of(const dynamics::System                  &system,
                                     const World::Address                    &place,
                                     const std::vector<dealii::Tensor<1, 3>> *deflection) const
{
  const BodyBatches  &copies = system.world.copies[place.group];
  const ElasticGroup &group  = system.world.group_of(place.group);
  const std::size_t   n      = copies.nodes.of_vertex.size();
  ElasticSnapshot     snapshot{
      std::vector<dealii::Tensor<1, 3>>(n), std::vector<dealii::Tensor<1, 3>>(n), {}, {}};
  std::vector<dealii::Tensor<1, 3>> position, velocity;
  group.nodes_now(system.world, place.copy, position, velocity);
  if (deflection != nullptr)
    for (unsigned int node = 0; node < copies.n_nodes(); ++node)
      position[node] += (*deflection)[node];
  for (unsigned int node = 0; node < copies.n_nodes(); ++node)
    {
      const unsigned int vertex     = copies.nodes.vertex[node];
      snapshot.displacement[vertex] = copies.displacement_to(position[node], place.copy, node);
      snapshot.velocity[vertex]     = velocity[node];
    }
  for (const Rim &rim : system.world.rims) // the hub knows the velocities of nodes that it holds
    if (rim.group == place.group)
      for (const unsigned int node : rim.border)
        snapshot.velocity[copies.nodes.vertex[node]] =
            system.world.velocity_at(rim.body, position[node], 0.);
  snapshot.stress.resize(copies.part->mesh->n_active_cells());
  for (const auto &recovery : cells_.at(place.group))
    {
      recovery->recover(position, snapshot.stress);
      if (recovery->has_faces())
        {
          snapshot.faces.resize(snapshot.stress.size());
          recovery->recover_faces(position, snapshot.faces);
        }
    }
  return snapshot;
}

Waists::Waists(const scene::Scene &scene, const dynamics::System &system)
{
  for (unsigned int g = 0; g < system.world.n_elastic_groups(); ++g)
    {
      const BodyBatches &copies = system.world.copies[g];
      const scene::Kind  kind   = kind_of(scene, system, g);
      if (kind != scene::Kind::inner_link && kind != scene::Kind::outer_link)
        continue;
      PlateStress plates(*copies.part, copies.nodes, scene.material, scene.elements.plates);
      plates_.emplace(g, Plates{std::move(plates), nullptr, {}, {}});
    }
  for (const ModalGroup *group : system.world.groups.modal())
    if (const auto found = plates_.find(group->copies()); found != plates_.end())
      {
        Plates &plates            = found->second;
        plates.modal              = group;
        const BodyBatches &copies = system.world.copies[group->copies()];
        plates.of_modes           = components_of_modes(plates.from_nodes, copies, *group);
        if (scene.measures.count(scene.bodies[copies.bodies.front()].part()) == 0)
          continue;
        const dealii::FullMatrix<double> squares = group->modal_matrix({}); // of frequencies
        plates.of_accelerations.resize(plates.of_modes.size());
        for (unsigned int m = 0; m < plates.of_modes.size(); ++m)
          add(plates.of_accelerations[m], -1. / squares(m, m), plates.of_modes[m]);
      }
}

void measure_waists(scene::Scene &scene, const MPI_Comm comm)
{
  for (const auto &[part, basis] : scene.bases)
    {
      if (basis->joints.empty() ||
          (part.kind != scene::Kind::inner_link && part.kind != scene::Kind::outer_link))
        continue;
      const mesh::Part &mesh = *scene.parts.at(part);
      const mesh::Nodes nodes(mesh);
      const PlateStress plates(mesh, nodes, scene.material, scene.elements.plates);
      statics::Cache    cache(statics::Cache::usual_folder());
      for (const reduction::Vector &response : reduction::kept_static_responses(
               mesh, scene.material, scene.elements, derivatives_of(plates, nodes), cache, comm))
        scene.measures[part].emplace_back(response.begin(), response.end());
    }
}

WaistComponents Waists::components(const dynamics::System &system, const unsigned int body) const
{
  const World          &world  = system.world;
  const World::Address &place  = world.elastic_address[body];
  const Plates         &plates = plates_.at(place.group);
  const ElasticGroup   &group  = world.group_of(place.group);
  WaistComponents       sum{};
  if (plates.modal != nullptr)
    {
      const bool measured = !plates.of_accelerations.empty();
      if (measured)
        {
          const std::vector<double> measures = plates.modal->measures_of(world, place.copy);
          for (unsigned int c = 0; c < n_waist_components; ++c)
            entry(sum, c) += measures[c];
        }
      if (!world.owns(body))
        return sum;
      const std::vector<double> of_modes = measured ?
                                               plates.modal->accelerations_of(world, place.copy) :
                                               plates.modal->amplitudes_of(world, place.copy);
      for (std::size_t m = 0; m < of_modes.size(); ++m)
        add(sum, of_modes[m], measured ? plates.of_accelerations[m] : plates.of_modes[m]);
      return sum;
    }
  if (!world.owns(body))
    return sum;
  std::vector<dealii::Tensor<1, 3>> position;
  position.reserve(plates.from_nodes.nodes().size());
  for (const unsigned int node : plates.from_nodes.nodes())
    position.push_back(group.position_now(system.world, place.copy, node));
  return plates.from_nodes.components(position);
}

RollerSurfaces::RollerSurfaces(const scene::Scene &scene, const dynamics::System &system)
{
  for (unsigned int g = 0; g < system.world.n_elastic_groups(); ++g)
    if (kind_of(scene, system, g) == scene::Kind::roller)
      for (const unsigned int body : system.world.copies[g].bodies)
        nodes_[body] = farthest_node(system.world.copies[g],
                                     transpose(scene.bodies[body].initial.rotation) *
                                         scene.drive.tight().normal);
}

dealii::Tensor<1, 3> RollerSurfaces::velocity(const dynamics::System &system,
                                              const unsigned int      body) const
{
  const World::Address &place = system.world.elastic_address[body];
  return system.world.group_of(place.group).velocity_now(system.world, place.copy, nodes_.at(body));
}
} // namespace chaindrive::observe
