// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/node_view.h>
#include <chaindrive/bodies/rigid_surface_nodes.h>
#include <chaindrive/bodies/world.h>

#include <utility>

namespace chaindrive
{
RigidSurfaceNodes::RigidSurfaceNodes(const unsigned int group, std::vector<Side> sides)
    : group_(group), sides_(std::move(sides))
{
}

void RigidSurfaceNodes::place_surface(World &world, const double earlier)
{
  BodyBatches   &copies = world.copies[group_];
  const NodeView position(copies.position), velocity(copies.velocity);
  for (const Side &side : sides_)
    {
      if (!copies.owns(side.copy))
        continue;
      const Frame &frame = world.frames[side.body];
      for (const unsigned int node : side.nodes)
        {
          const dealii::Tensor<1, 3> x =
              frame.position + frame.rotation * dealii::Tensor<1, 3>(copies.nodes.position[node]);
          const std::size_t at = copies.index(side.copy, node);
          position.set(at, x);
          velocity.set(at, world.velocity_at(side.body, x, earlier));
        }
    }
}

void RigidSurfaceNodes::gather_forces(World &world)
{
  BodyBatches   &copies = world.copies[group_];
  const NodeView position(std::as_const(copies.position));
  const NodeView force(copies.force);
  for (const Side &side : sides_)
    {
      if (!copies.owns(side.copy))
        continue;
      for (const unsigned int node : side.nodes)
        {
          const std::size_t          at = copies.index(side.copy, node);
          const dealii::Tensor<1, 3> couple =
              cross_product_3d(position[at] - world.frames[side.body].position, force.extract(at));
          for (unsigned int d = 0; d < 3; ++d)
            world.moment.local_element(3 * side.body + d) += couple[d];
        }
    }
}
} // namespace chaindrive
