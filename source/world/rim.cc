// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface_nodes.h>
#include <chaindrive/world/rim.h>

#include <algorithm>
#include <utility>

namespace chaindrive
{
Rim::Rim(const unsigned int                  the_body,
         const unsigned int                  the_hub,
         const unsigned int                  the_group,
         std::shared_ptr<const mesh::Sector> the_sector,
         Copies                             &copies)
    : body(the_body)
    , hub(the_hub)
    , group(the_group)
    , sector(std::move(the_sector))
    , border(mesh::SurfaceNodes(*copies.part, copies.nodes, mesh::hub).node)
    , inertia(0.)
    , border_inertia(0.)
{
  mesh::Nodes       &nodes = copies.nodes;
  const unsigned int n     = sector->n_sectors;
  for (const auto &[v, w] : sector->seam)
    {
      const unsigned int a = nodes.of_vertex[v], b = nodes.of_vertex[w];
      nodes.mass[a] = nodes.mass[b] = 0.5 * (nodes.mass[a] + nodes.mass[b]);
      for (unsigned int s = 0; s < n; ++s)
        seam.emplace_back(copies.index(s, a, 0), copies.index((s + 1) % n, b, 0));
    }
  for (Copies::Vector *vector : {&copies.position, &copies.velocity})
    for (const auto &[i, j] : seam)
      for (unsigned int d = 0; d < 3; ++d)
        vector->local_element(j + d * n_lanes) = vector->local_element(i + d * n_lanes);

  for (unsigned int node = 0; node < nodes.size(); ++node)
    {
      const dealii::Point<3> &x = nodes.position[node];
      (std::binary_search(border.begin(), border.end(), node) ? border_inertia : inertia) +=
          n * nodes.mass[node] * (x[0] * x[0] + x[1] * x[1]);
    }
  for (unsigned int s = 0; s < n; ++s)
    for (const unsigned int node : border)
      for (unsigned int d = 0; d < 3; ++d)
        copies.velocity.local_element(copies.index(s, node, d)) = 0.;
}

void Rim::hold(Copies &copies, const Frame &frame) const
{
  for (unsigned int s = 0; s < sector->n_sectors; ++s)
    {
      const Frame here = sector->frame(frame, s);
      for (const unsigned int node : border)
        {
          const dealii::Tensor<1, 3> x =
              here.position + here.rotation * dealii::Tensor<1, 3>(copies.nodes.position[node]);
          for (unsigned int d = 0; d < 3; ++d)
            copies.position.local_element(copies.index(s, node, d)) = x[d];
        }
    }
}
} // namespace chaindrive
