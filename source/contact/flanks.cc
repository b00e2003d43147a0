// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/facet_flanks.h>
#include <chaindrive/contact/tooth_surface.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace chaindrive::contact
{
Touch Flanks::touch(const World                &world,
                    const dealii::Tensor<1, 3> &x,
                    const double                within,
                    unsigned int               &hint,
                    Projection                 &projection) const
{
  const Frame &hub = world.frames[family_.sprocket];
  const Facet  facet =
      nearest(dealii::transpose(hub.rotation) * (x - hub.position), within, hint, projection);
  if (!facet.found)
    {
      projection     = Projection(); // far away it moves with the hub
      projection.arm = x - hub.position;
      return {};
    }
  const auto u = complete(world, x, facet, projection);

  // the distance changes by no more than the displacement, to first order by its normal part
  if (facet.distance > projection.displacement.norm())
    {
      Touch apart;
      apart.gap     = facet.distance - (hub.rotation * facet.normal) * projection.displacement;
      apart.feature = facet.feature;
      return apart;
    }

  unsigned int from  = hint;
  Touch        touch = touch_flanks(family_, x - projection.displacement, 0., within, hub, from);
  if (touch.gap < 0.)
    {
      // what a step of the point along the surface changes in the displacement's normal part
      const dealii::Tensor<1, 3> normal = touch.normal;
      dealii::Tensor<1, 3>       tilt;
      for (unsigned int i = 0; i < 4; ++i)
        tilt += (normal * u[i]) * facet.gradients[i];
      touch.normal -= hub.rotation * tilt;
      touch.normal /= touch.normal.norm();
      touch.point = x;
      set_tangents(touch, hub);
    }
  return touch;
}

std::array<dealii::Tensor<1, 3>, 4> Flanks::complete(const World                &world,
                                                     const dealii::Tensor<1, 3> &x,
                                                     const Facet                &facet,
                                                     Projection                 &projection) const
{
  const Frame       &hub    = world.frames[family_.sprocket];
  const BodyBatches &copies = world.copies[group_];
  projection.displacement = projection.arm = dealii::Tensor<1, 3>();
  std::array<dealii::Tensor<1, 3>, 4> u;
  for (unsigned int i = 0; i < 4; ++i)
    {
      dealii::Tensor<1, 3> now;
      for (unsigned int d = 0; d < 3; ++d)
        now[d] = copies.position.local_element(projection.nodes[i] + d * n_lanes);
      u[i] = now - hub.position - hub.rotation * facet.nodes[i];
      projection.displacement += projection.weights[i] * u[i];
      projection.arm += projection.weights[i] * (x - now);
    }
  return u;
}

dealii::Tensor<1, 3> Flanks::velocity(const World &world, const Projection &projection) const
{
  const BodyBatches   &copies = world.copies[group_];
  dealii::Tensor<1, 3> v =
      cross_product_3d(world.frames[family_.sprocket].angular_velocity, projection.arm);
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      v[d] +=
          projection.weights[i] * copies.velocity.local_element(projection.nodes[i] + d * n_lanes);
  return v;
}

void Flanks::add_force(World                      &world,
                       const Projection           &projection,
                       const dealii::Tensor<1, 3> &f) const
{
  BodyBatches &copies = world.copies[group_];
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      {
        const double half = 0.5 * projection.weights[i] * f[d];
        copies.force.local_element(projection.nodes[i] + d * n_lanes) += half;
        copies.force.local_element(projection.twins[i] + d * n_lanes) += half;
      }
  const dealii::Tensor<1, 3> couple = cross_product_3d(projection.arm, f);
  for (unsigned int d = 0; d < 3; ++d)
    world.moment.local_element(3 * family_.sprocket + d) += couple[d];
}

TributaryArea largest_share(const mesh::SurfaceNodes &side, const BodyBatches &copies)
{
  std::vector<double> stations;
  for (const unsigned int n : side.node)
    stations.push_back(copies.nodes.position[n][2]);
  std::sort(stations.begin(), stations.end());
  TributaryArea share;
  for (unsigned int i = 1; i < stations.size(); ++i)
    share.along = std::max(share.along, stations[i] - stations[i - 1]);
  const double area = *std::max_element(side.area.begin(), side.area.end());
  share.across      = share.along > 0. ? area / share.along : std::sqrt(area);
  return share;
}

std::unique_ptr<const Flanks>
make_flanks(const scene::ToothFamily &family, const World &world, const Rim &rim)
{
  if (family.facets)
    return std::make_unique<const FacetFlanks>(family, world, rim);
  return std::make_unique<const ToothSurface>(family, world, rim);
}
} // namespace chaindrive::contact
