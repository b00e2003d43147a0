// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/facet_flanks.h>
#include <chaindrive/contact/family.h>
#include <chaindrive/mesh/facet_surface.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
FacetFlanks::FacetFlanks(const scene::ToothFamily &family, const World &world, const Rim &rim)
    : Flanks(family, rim)
{
  const Copies &copies = world.copies[group_];
  place_.resize(copies.nodes.of_vertex.size());
  position_.resize(place_.size());
  for (unsigned int f = 0; f < family.facets->n_facets(); ++f)
    for (const unsigned int v : family.facets->vertices(f))
      {
        const unsigned int node = copies.nodes.of_vertex[v];
        place_[v]               = copies.index(0, node, 0);
        position_[v]            = copies.nodes.position[node];
      }
}

Touch FacetFlanks::touch(const World                &world,
                         const dealii::Tensor<1, 3> &x,
                         const double                within,
                         unsigned int               &hint,
                         Foot                       &foot) const
{
  const Frame           &hub = world.frames[family_.sprocket];
  const dealii::Point<3> X(dealii::transpose(hub.rotation) * (x - hub.position));
  const double           z = std::clamp(X[2], -family_.half_width, family_.half_width);
  const mesh::Projection nearest =
      family_.facets->closest_point(dealii::Point<3>(X[0], X[1], z), within, hint);
  if (!nearest.found)
    {
      foot     = Foot(); // far away it moves with the hub
      foot.arm = x - hub.position;
      return {};
    }
  hint         = nearest.facet;
  foot.weights = nearest.weights;
  std::array<dealii::Tensor<1, 3>, 4> reference;
  for (unsigned int i = 0; i < 4; ++i)
    {
      const unsigned int v = family_.facets->vertices(nearest.facet)[i];
      foot.nodes[i]        = place_[v];
      reference[i]         = position_[v];
    }
  const auto u = complete(world, x, reference, foot);

  // the distance changes by no more than the displacement, to first order by its normal part
  if (nearest.distance > foot.displacement.norm())
    {
      Touch apart;
      apart.gap = nearest.distance - (hub.rotation * nearest.normal) * foot.displacement;
      return apart;
    }

  unsigned int facet = nearest.facet;
  Touch        touch = touch_flanks(family_, x - foot.displacement, 0., within, hub, facet);
  if (touch.gap < 0.)
    {
      // what a step of the point along the surface changes in the displacement's normal part
      const auto                 gradients = family_.facets->gradients(nearest);
      const dealii::Tensor<1, 3> normal    = touch.normal;
      dealii::Tensor<1, 3>       tilt;
      for (unsigned int i = 0; i < 4; ++i)
        tilt += (normal * u[i]) * gradients[i];
      if (z != X[2])
        tilt[2] = 0.;
      touch.normal -= hub.rotation * tilt;
      touch.normal /= touch.normal.norm();
      touch.point = x;
      set_tangents(touch, hub);
    }
  return touch;
}

ClosedSide FacetFlanks::closed_side(const double              stiffness,
                                    const Copies             &flanks,
                                    const mesh::SurfaceNodes &slaves,
                                    const Copies             &of_slaves) const
{
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
  const Share              slave = largest_share(slaves, of_slaves);
  ClosedSide               side;
  side.group = group_;
  side.stiffness.resize(flanks.n_nodes());
  for (unsigned int i = 0; i < nodes.size(); ++i)
    {
      const unsigned int node = nodes.node[i];
      const auto &[low, high] = reach[node];
      const Share  share(nodes.area[i], flanks.nodes.position[node][2], low, high);
      const double k = stiffness * carried_area(share, slave);
      side.hold(node, k, flanks.nodes.mass[node]);
    }
  return side;
}
} // namespace chaindrive::contact
