// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/closed_joint.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::contact
{
ClosedSide closed_side(const mesh::CylinderGrid                  &grid,
                       const unsigned int                         surface,
                       const std::function<double(unsigned int)> &area,
                       const double                               stiffness,
                       const World                               &world,
                       const unsigned int                         group)
{
  const BodyBatches &copies  = world.copies[group];
  double             inertia = std::numeric_limits<double>::max();
  for (const World::Rotation &rotation : world.rotations)
    if (world.node_address[rotation.body].group == group)
      for (unsigned int d = 0; d < 3; ++d)
        inertia = std::min(inertia, rotation.inertia[d]);

  ClosedSide side;
  side.group   = group;
  side.surface = surface;
  if (group < world.n_elastic_groups())
    {
      side.stiffness.resize(copies.n_nodes());
      side.normal.resize(copies.n_nodes());
    }
  for (unsigned int s = 0; s < grid.n_rings(); ++s)
    {
      const double k = stiffness * area(s);
      for (unsigned int c = 0; c < grid.n_circumferential(); ++c)
        {
          const unsigned int node = copies.nodes.of_vertex[grid.vertex_at(s, c)];
          if (side.stiffness.empty())
            side.eigenvalue +=
                k * (1. / world.mass[copies.bodies.front()] +
                     dealii::Tensor<1, 3>(copies.nodes.position[node]).norm_square() / inertia);
          else
            {
              side.add_spring(node, k, copies.nodes.mass[node]);
              side.normal[node][0] = std::cos(grid.angles[c]);
              side.normal[node][1] = std::sin(grid.angles[c]);
            }
        }
    }
  return side;
}

ClosedWindow window_of(const reduction::RoundFlexibility &side,
                       const mesh::CylinderGrid          &grid,
                       const unsigned int                 first,
                       const unsigned int                 last,
                       const scene::ContactLaw           &law)
{
  ClosedWindow window;
  window.surface    = side.surface;
  window.n_columns  = side.n_columns;
  window.n_rings    = last + 1 - first;
  window.first_ring = first;
  for (unsigned int r = first; r <= last; ++r)
    {
      window.across.push_back(law.friction > 0. ? law.tangential_stiffness * grid.area(r, 0) : 0.);
      for (unsigned int c = 0; c < side.n_columns; ++c)
        window.node.push_back(side.node[r * side.n_columns + c]);
      for (unsigned int s = first; s <= last; ++s)
        for (unsigned int d = 0; d < side.n_columns; ++d)
          window.flexibility.push_back(side.at(r, s, d));
    }
  return window;
}
} // namespace chaindrive::contact
