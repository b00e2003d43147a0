// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/world.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/scene.h>

#include <map>
#include <set>
#include <utility>

namespace chaindrive
{
void World::add_followers(const scene::Scene &scene)
{
  // the sides of rigid bodies that touch with their nodes
  std::map<scene::Kind, std::map<unsigned int, std::set<unsigned int>>> sides;
  for (const scene::BoreFamily &bores : scene.bores)
    if (bores.elastic)
      for (const scene::BorePair &pair : bores.pairs)
        for (const auto &[body, side] : {std::make_pair(pair.master, pair.master_surface),
                                         std::make_pair(pair.slave.body, pair.slave_surface)})
          if (elastic_address[body].group == Address::none)
            sides[scene.bodies[body].kind][body].insert(side);

  for (const auto &[kind, of_bodies] : sides)
    {
      const unsigned int        group = static_cast<unsigned int>(copies.size());
      std::vector<unsigned int> bodies;
      for (const auto &entry : of_bodies)
        {
          node_address[entry.first] = {group, static_cast<unsigned int>(bodies.size())};
          bodies.push_back(entry.first);
        }
      std::vector<unsigned int> first_batch(n_ranks_ + 1, BodyBatches::n_batches_of(bodies.size()));
      first_batch.front() = 0;
      copies.emplace_back(scene.parts.at(kind), bodies, scene.bodies, first_batch, comm_);
      ++n_follower_groups_;
      for (const auto &[body, surfaces] : of_bodies)
        for (const unsigned int surface : surfaces)
          followers.push_back({body,
                               node_address[body],
                               mesh::SurfaceNodes(*copies.back().part,
                                                  copies.back().nodes,
                                                  static_cast<mesh::Surface>(surface))
                                   .node});
    }
}

void World::place_followers(const double earlier)
{
  for (const Follower &follower : followers)
    {
      BodyBatches &group = copies[follower.place.group];
      if (!group.owns(follower.place.copy))
        continue;
      const Frame &frame = frames[follower.body];
      for (const unsigned int node : follower.nodes)
        {
          const dealii::Tensor<1, 3> x =
              frame.position + frame.rotation * dealii::Tensor<1, 3>(group.nodes.position[node]);
          const dealii::Tensor<1, 3> v     = velocity_at(follower.body, x, earlier);
          const std::size_t          first = group.index(follower.place.copy, node, 0);
          for (unsigned int d = 0; d < 3; ++d)
            {
              group.position.local_element(first + d * n_lanes) = x[d];
              group.velocity.local_element(first + d * n_lanes) = v[d];
            }
        }
    }
}

void World::take_moments_of_followers()
{
  for (const Follower &follower : followers)
    {
      BodyBatches &group = copies[follower.place.group];
      if (!group.owns(follower.place.copy))
        continue;
      for (const unsigned int node : follower.nodes)
        {
          const std::size_t    first = group.index(follower.place.copy, node, 0);
          dealii::Tensor<1, 3> arm, f;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const std::size_t i = first + d * n_lanes;
              arm[d] = group.position.local_element(i) - frames[follower.body].position[d];
              f[d]   = std::exchange(group.force.local_element(i), 0.);
            }
          const dealii::Tensor<1, 3> couple = cross_product_3d(arm, f);
          for (unsigned int d = 0; d < 3; ++d)
            moment.local_element(3 * follower.body + d) += couple[d];
        }
    }
}
} // namespace chaindrive
