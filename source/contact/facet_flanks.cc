// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/facet_flanks.h>
#include <chaindrive/mesh/surface/facet_surface.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
FacetFlanks::FacetFlanks(const scene::ToothFamily &family, const World &world, const Rim &rim)
    : ElasticFlanks(family, rim)
{
  const BodyBatches &copies = world.copies[group_];
  place_.resize(copies.nodes.of_vertex.size());
  position_.resize(place_.size());
  for (unsigned int f = 0; f < family.facets->n_facets(); ++f)
    for (const unsigned int v : family.facets->vertices(f))
      {
        const unsigned int node = copies.nodes.of_vertex[v];
        place_[v]               = copies.index(0, node);
        position_[v]            = copies.nodes.position[node];
      }

  in_gap_.resize(family.teeth);
  for (const unsigned int node :
       mesh::SurfaceNodes(*copies.part, copies.nodes, mesh::tooth_flanks).node)
    in_gap_[gap_of(dealii::Tensor<1, 3>(copies.nodes.position[node]))].push_back({0, node});
  for (unsigned int f = 0; f < family.facets->n_facets(); ++f)
    for (const unsigned int v : family.facets->vertices(f))
      for (const unsigned int w : family.facets->vertices(f))
        longest_ = std::max(longest_, position_[v].distance(position_[w]));
}

ElasticFlanks::Facet FacetFlanks::nearest(const dealii::Tensor<1, 3> &x,
                                          const double                within,
                                          unsigned int               &hint,
                                          Projection                 &projection) const
{
  const double           z = std::clamp(x[2], -family_.half_width, family_.half_width);
  const mesh::Projection nearest =
      family_.facets->closest_point(dealii::Point<3>(x[0], x[1], z), within, hint);
  Facet facet;
  facet.found = nearest.found;
  if (!nearest.found)
    return facet;
  hint               = nearest.facet;
  facet.distance     = nearest.distance;
  facet.normal       = nearest.normal;
  facet.gradients    = family_.facets->gradients(nearest);
  projection.weights = nearest.weights;
  for (unsigned int i = 0; i < 4; ++i)
    {
      const unsigned int v = family_.facets->vertices(nearest.facet)[i];
      projection.nodes[i]  = place_[v];
      facet.nodes[i]       = position_[v];
      if (z != x[2])
        facet.gradients[i][2] = 0.;
    }
  projection.twins = projection.nodes; // one copy is the whole sprocket
  return facet;
}

ClosedSide FacetFlanks::closed_side(const World              &world,
                                    const double              stiffness,
                                    const mesh::SurfaceNodes &slaves,
                                    const BodyBatches        &of_slaves) const
{
  const BodyBatches &flanks = world.copies[group_];
  // the part of the axis that a node's facets cover
  std::vector<std::array<double, 2>> reach(flanks.n_nodes(), {{1e300, -1e300}});
  for (unsigned int f = 0; f < family_.facets->n_facets(); ++f)
    for (const unsigned int v : family_.facets->vertices(f))
      for (const unsigned int w : family_.facets->vertices(f))
        {
          auto &[low, high] = reach[flanks.nodes.of_vertex[v]];
          low               = std::min(low, position_[w][2]);
          high              = std::max(high, position_[w][2]);
        }

  const mesh::SurfaceNodes nodes(*flanks.part, flanks.nodes, mesh::tooth_flanks);
  const TributaryArea      slave = largest_share(slaves, of_slaves);
  ClosedSide               side;
  side.group   = group_;
  side.surface = mesh::tooth_flanks;
  side.stiffness.resize(flanks.n_nodes());
  for (unsigned int i = 0; i < nodes.size(); ++i)
    {
      const unsigned int node = nodes.node[i];
      const auto &[low, high] = reach[node];
      const TributaryArea share(nodes.area[i], flanks.nodes.position[node][2], low, high);
      const double        k = stiffness * carried_area(share, slave);
      side.add_spring(node, k, flanks.nodes.mass[node]);
    }
  return side;
}
} // namespace chaindrive::contact
