// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/node_view.h>
#include <chaindrive/contact/arc_flanks.h>
#include <chaindrive/contact/facet_flanks.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace chaindrive::contact
{
Touch ElasticFlanks::project(const World                &world,
                             const dealii::Tensor<1, 3> &x,
                             const double                radius,
                             const double                within,
                             unsigned int               &hint,
                             Projection                 &projection) const
{
  const Frame &hub = world.frames[body()];
  const Facet  facet =
      nearest(dealii::transpose(hub.rotation) * (x - hub.position), within, hint, projection);
  if (!facet.found)
    {
      projection     = Projection(); // far away it moves with the hub
      projection.arm = x - hub.position;
      return {};
    }
  const auto u = complete(world, x, facet, projection);

  if (std::isnan(projection.displacement.norm_square()))
    {
      Touch unknown; // of nodes that are not numbers
      unknown.gap = std::numeric_limits<double>::quiet_NaN();
      return unknown;
    }

  // the distance changes by no more than the displacement, to first order by its normal part
  if (facet.distance - radius > projection.displacement.norm())
    {
      Touch apart;
      apart.gap = facet.distance - (hub.rotation * facet.normal) * projection.displacement - radius;
      apart.feature = facet.feature;
      return apart;
    }

  unsigned int from  = hint;
  Touch        touch = project_on_rigid(world, x - projection.displacement, radius, within, from);
  if (touch.gap < 0.)
    {
      // what a step of the point along the surface changes in the displacement's normal part
      const dealii::Tensor<1, 3> normal = touch.normal;
      dealii::Tensor<1, 3>       tilt;
      for (unsigned int i = 0; i < 4; ++i)
        tilt += (normal * u[i]) * facet.gradients[i];
      touch.normal -= hub.rotation * tilt;
      touch.normal /= touch.normal.norm();
      touch.point = x - radius * touch.normal;
      set_tangents(touch, hub);
    }
  return touch;
}

std::array<dealii::Tensor<1, 3>, 4> ElasticFlanks::complete(const World                &world,
                                                            const dealii::Tensor<1, 3> &x,
                                                            const Facet                &facet,
                                                            Projection &projection) const
{
  const Frame   &hub = world.frames[body()];
  const NodeView position(world.copies[group_].position);
  projection.displacement = projection.arm = dealii::Tensor<1, 3>();
  std::array<dealii::Tensor<1, 3>, 4> u;
  for (unsigned int i = 0; i < 4; ++i)
    {
      const dealii::Tensor<1, 3> now = position[projection.nodes[i]];
      u[i]                           = now - hub.position - hub.rotation * facet.nodes[i];
      projection.displacement += projection.weights[i] * u[i];
      projection.arm += projection.weights[i] * (x - now);
    }
  return u;
}

dealii::Tensor<1, 3> ElasticFlanks::relative_velocity(const World &world,
                                                      const dealii::Tensor<1, 3> &,
                                                      const Projection           &projection,
                                                      const dealii::Tensor<1, 3> &v,
                                                      const double) const
{
  const NodeView       velocity(world.copies[group_].velocity);
  dealii::Tensor<1, 3> of_flank =
      cross_product_3d(world.frames[body()].angular_velocity, projection.arm);
  for (unsigned int i = 0; i < 4; ++i)
    of_flank += projection.weights[i] * velocity[projection.nodes[i]];
  return v - of_flank;
}

void ElasticFlanks::add_opposite(World &world,
                                 const dealii::Tensor<1, 3> &,
                                 const Touch &,
                                 const Projection &projection,
                                 const PointForce &on_slave) const
{
  const dealii::Tensor<1, 3> f      = -on_slave.total;
  BodyBatches               &copies = world.copies[group_];
  const NodeView             force(copies.force);
  for (unsigned int i = 0; i < 4; ++i)
    {
      copies.press(projection.nodes[i]);
      copies.press(projection.twins[i]);
      const dealii::Tensor<1, 3> half = 0.5 * projection.weights[i] * f;
      force.add(projection.nodes[i], half);
      force.add(projection.twins[i], half);
    }
  const dealii::Tensor<1, 3> couple = cross_product_3d(projection.arm, f);
  for (unsigned int d = 0; d < 3; ++d)
    world.moment.local_element(3 * body() + d) += couple[d];
}

std::set<unsigned int> ElasticFlanks::gaps_near(const World                &world,
                                                const dealii::Tensor<1, 3> &x,
                                                const double                radius,
                                                const double                margin) const
{
  const Frame               &hub      = world.frames[body()];
  const dealii::Tensor<1, 3> local    = dealii::transpose(hub.rotation) * (x - hub.position);
  const double               distance = radius + margin + beyond(radius),
               from_axis              = std::hypot(local[0], local[1]);
  const int    n                      = static_cast<int>(family_.teeth);
  const double per_gap                = 2. * dealii::numbers::PI / n;
  const double half   = from_axis > distance ? std::asin(distance / from_axis) / per_gap : n;
  const double centre = std::atan2(local[1], local[0]) / per_gap;
  int          first  = static_cast<int>(std::lround(centre - half)),
      last            = static_cast<int>(std::lround(centre + half));
  last                = std::min(last, first + n - 1);
  std::set<unsigned int> gaps;
  for (int gap = first; gap <= last; ++gap)
    gaps.insert((gap % n + n) % n);
  return gaps;
}

TributaryArea largest_share(const mesh::SurfaceNodes &side, const BodyBatches &copies)
{
  std::vector<double> rings;
  for (const unsigned int n : side.node)
    rings.push_back(copies.nodes.position[n][2]);
  std::sort(rings.begin(), rings.end());
  TributaryArea share;
  for (unsigned int i = 1; i < rings.size(); ++i)
    share.along = std::max(share.along, rings[i] - rings[i - 1]);
  const double area = *std::max_element(side.area.begin(), side.area.end());
  share.across      = share.along > 0. ? area / share.along : std::sqrt(area);
  return share;
}

std::shared_ptr<const Surface> make_flanks(const scene::ToothFamily &family, const World &world)
{
  const Rim *rim = world.rim_of(family.sprocket);
  if (rim == nullptr)
    return std::make_shared<const RigidFlanks>(family);
  if (family.facets)
    return std::make_shared<const FacetFlanks>(family, world, *rim);
  return std::make_shared<const ArcFlanks>(family, world, *rim);
}

scene::SurfaceFamily on_flanks(const scene::ToothFamily &family, const World &world)
{
  return {family.name,
          make_flanks(family, world),
          family.law,
          family.slaves,
          family.elastic,
          family.slave_surface,
          family.tooth_stiffness,
          family.half_angle,
          {scene::Interface::roller_teeth, family.sprocket, family.strand}};
}
} // namespace chaindrive::contact
