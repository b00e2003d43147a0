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
} // namespace chaindrive
