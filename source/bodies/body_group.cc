// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/world.h>

namespace chaindrive
{
dealii::Tensor<1, 3>
BodyGroup::position_now(const World &world, const unsigned int copy, const unsigned int node) const
{
  return world.copies[elastic_copies()].position_now(copy, node);
}

dealii::Tensor<1, 3>
BodyGroup::velocity_now(const World &world, const unsigned int copy, const unsigned int node) const
{
  const BodyBatches &copies = world.copies[elastic_copies()];
  return NodeView(copies.velocity)[copies.index(copy, node)];
}

void BodyGroup::nodes_now(const World                       &world,
                          const unsigned int                 copy,
                          std::vector<dealii::Tensor<1, 3>> &position,
                          std::vector<dealii::Tensor<1, 3>> &velocity) const
{
  const unsigned int n_nodes = world.copies[elastic_copies()].n_nodes();
  position.resize(n_nodes);
  velocity.resize(n_nodes);
  for (unsigned int node = 0; node < n_nodes; ++node)
    {
      position[node] = position_now(world, copy, node);
      velocity[node] = velocity_now(world, copy, node);
    }
}
} // namespace chaindrive
