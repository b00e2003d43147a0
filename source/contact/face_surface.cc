// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/node_view.h>
#include <chaindrive/contact/face_surface.h>

#include <utility>

namespace chaindrive::contact
{
FaceSurface::FaceSurface(const unsigned int       body,
                         const unsigned int       group,
                         const MovingFacets      &facets,
                         std::vector<std::size_t> nodes)
    : Surface(body), group_(group), facets_(facets), nodes_(std::move(nodes))
{
}

Touch FaceSurface::project(const World                &world,
                           const dealii::Tensor<1, 3> &x,
                           const double                radius,
                           double /*within*/,
                           unsigned int &hint,
                           Projection   &projection) const
{
  const NodeValues               position{NodeView(world.copies[group_].position), nodes_};
  const MovingFacets::Projection found = facets_.project(position, x, hint);
  hint                                 = found.facet;
  if (found.facet == MovingFacets::none)
    {
      projection = Projection(); // of a point beside it, the velocity against a side at rest
      return {};
    }
  for (unsigned int a = 0; a < 4; ++a)
    projection.nodes[a] = nodes_[found.node[a]];
  projection.weights   = found.weight;
  projection.gradients = found.gradient;

  Touch touch;
  touch.gap     = found.gap - radius;
  touch.normal  = found.normal;
  touch.feature = found.facet;
  if (touch.gap < 0.)
    {
      const dealii::Tensor<1, 3> fixed =
          position(static_cast<unsigned int>(nodes_.size()) - 1) - position(0);
      touch.point = x - radius * touch.normal;
      touch.along = fixed - (fixed * touch.normal) * touch.normal;
      touch.along /= touch.along.norm();
      touch.across = cross_product_3d(touch.normal, touch.along);
    }
  return touch;
}

dealii::Tensor<1, 3> FaceSurface::relative_velocity(const World &world,
                                                    const dealii::Tensor<1, 3> &,
                                                    const Projection           &projection,
                                                    const dealii::Tensor<1, 3> &v,
                                                    double) const
{
  const NodeView       velocity(world.copies[group_].velocity);
  dealii::Tensor<1, 3> relative = v;
  for (unsigned int a = 0; a < 4; ++a)
    relative -= projection.weights[a] * velocity[projection.nodes[a]];
  return relative;
}

dealii::Tensor<1, 3> FaceSurface::slip_velocity(const World                &world,
                                                const Touch                &touch,
                                                const Projection           &projection,
                                                const dealii::Tensor<1, 3> &relative) const
{
  const NodeView       velocity(world.copies[group_].velocity);
  dealii::Tensor<1, 3> tilt_rate;
  for (unsigned int a = 0; a < 4; ++a)
    tilt_rate += (touch.normal * velocity[projection.nodes[a]]) * projection.gradients[a];
  return relative + touch.gap * tilt_rate;
}

void FaceSurface::add_opposite(World &world,
                               const dealii::Tensor<1, 3> &,
                               const Touch      &touch,
                               const Projection &projection,
                               const PointForce &f) const
{
  BodyBatches   &copies = world.copies[group_];
  const NodeView force(copies.force);
  for (unsigned int a = 0; a < 4; ++a)
    {
      copies.press(projection.nodes[a]);
      force.add(projection.nodes[a],
                -projection.weights[a] * f.total +
                    touch.gap * (f.tangential * projection.gradients[a]) * touch.normal);
    }
}
} // namespace chaindrive::contact
