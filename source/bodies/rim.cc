// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/rim.h>
#include <chaindrive/mesh/surface/surface_nodes.h>

#include <algorithm>
#include <utility>

namespace chaindrive
{
Rim::Rim(const unsigned int                  the_body,
         const unsigned int                  the_group,
         std::shared_ptr<const mesh::Sector> the_sector,
         BodyBatches                        &copies)
    : body(the_body)
    , group(the_group)
    , sector(std::move(the_sector))
    , border(mesh::SurfaceNodes(*copies.part, copies.nodes, mesh::hub).node)
    , inertia(0.)
{
  mesh::Nodes       &nodes = copies.nodes;
  const unsigned int n     = sector->n_sectors;
  for (const auto &[v, w] : sector->seam)
    {
      const unsigned int a = nodes.of_vertex[v], b = nodes.of_vertex[w];
      nodes.mass[a] = nodes.mass[b] = 0.5 * (nodes.mass[a] + nodes.mass[b]);
    }
  for_each_pair(copies, [&copies](unsigned int s, unsigned int a, unsigned int t, unsigned int b) {
    if (copies.owns(s) && copies.owns(t))
      for (BodyBatches::Vector *vector : {&copies.position, &copies.velocity})
        NodeView(*vector).set(copies.index(t, b), NodeView(*vector)[copies.index(s, a)]);
    else if (copies.owns(s))
      copies.want(t, {b});
    else if (copies.owns(t))
      copies.want(s, {a});
  });
  // rollers of any rank may meet any tooth, but few at a time
  const mesh::SurfaceNodes flanks(*copies.part, nodes, mesh::tooth_flanks);
  for (unsigned int s = 0; s < n; ++s)
    copies.may_want(s, flanks.node);

  inertia = sector->inertia(nodes).free;
  for (unsigned int s = 0; s < n; ++s)
    for (const unsigned int node : copies.owns(s) ? border : std::vector<unsigned int>())
      NodeView(copies.velocity).set(copies.index(s, node), dealii::Tensor<1, 3>());
}

template <typename Visit>
void Rim::for_each_pair(const BodyBatches &copies, const Visit &visit) const
{
  for (const auto &[v, w] : sector->seam)
    for (unsigned int s = 0; s < sector->n_sectors; ++s)
      visit(s, copies.nodes.of_vertex[v], (s + 1) % sector->n_sectors, copies.nodes.of_vertex[w]);
}

void Rim::find_seam(const BodyBatches &copies)
{
  for_each_pair(copies, [&](unsigned int s, unsigned int a, unsigned int t, unsigned int b) {
    if (copies.owns(s) && copies.owns(t))
      seam_.emplace_back(copies.index(s, a), copies.index(t, b));
    else if (copies.owns(s))
      seam_with_others_.emplace_back(copies.index(s, a), copies.index(t, b));
    else if (copies.owns(t))
      seam_with_others_.emplace_back(copies.index(t, b), copies.index(s, a));
  });
}

void Rim::even_out_forces(BodyBatches &copies) const
{
  const NodeView force(copies.force);
  for (const auto &[own, ghost] : seam_with_others_)
    {
      const dealii::Tensor<1, 3> half = 0.5 * force[own];
      force.set(own, half);
      force.set(ghost, half);
    }
  for (const auto &[i, j] : seam_)
    {
      const dealii::Tensor<1, 3> mean = 0.5 * (force[i] + force[j]);
      force.set(i, mean);
      force.set(j, mean);
    }
}

void Rim::fix_to_hub(BodyBatches &copies, const Frame &frame) const
{
  for (unsigned int s = 0; s < sector->n_sectors; ++s)
    {
      if (!copies.owns(s))
        continue;
      const Frame here = sector->frame(frame, s);
      for (const unsigned int node : border)
        {
          const dealii::Tensor<1, 3> x =
              here.position + here.rotation * dealii::Tensor<1, 3>(copies.nodes.position[node]);
          NodeView(copies.position).set(copies.index(s, node), x);
        }
    }
}
} // namespace chaindrive
