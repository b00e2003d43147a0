// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/rigid_flanks.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/mesh/surface/facet_surface.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
RigidFlanks::RigidFlanks(const scene::ToothFamily &family)
    : Surface(family.sprocket), family_(family)
{
  family_.slaves.clear();
}

unsigned int RigidFlanks::gap_of(const dealii::Tensor<1, 3> &p) const
{
  const double gaps = std::atan2(p[1], p[0]) * family_.teeth / (2. * dealii::numbers::PI);
  return (static_cast<int>(std::lround(gaps)) + family_.teeth) % family_.teeth;
}

Touch RigidFlanks::project(const World                &world,
                           const dealii::Tensor<1, 3> &x,
                           const double                radius,
                           const double                within,
                           unsigned int               &hint,
                           Projection &) const
{
  return project_on_rigid(world, x, radius, within, hint);
}

Touch RigidFlanks::project_on_rigid(const World                &world,
                                    const dealii::Tensor<1, 3> &x,
                                    const double                radius,
                                    const double                within,
                                    unsigned int               &hint) const
{
  const Frame               &master = world.frames[body()];
  const dealii::Tensor<1, 3> local  = dealii::transpose(master.rotation) * (x - master.position);

  Touch                touch;
  dealii::Tensor<1, 3> normal;
  if (family_.facets)
    {
      const double z = std::clamp(local[2], -family_.half_width, family_.half_width);
      const auto   nearest =
          family_.facets->closest_point(dealii::Point<3>(local[0], local[1], z), within, hint);
      if (!nearest.found)
        return touch;
      touch.gap = nearest.distance - radius;
      normal    = nearest.normal;
      hint      = nearest.facet;
      if (touch.gap < 0.)
        touch.feature = gap_of(local);
    }
  else
    {
      const auto nearest = family_.form->closest_point(dealii::Point<2>(local[0], local[1]));
      touch.gap          = nearest.distance - radius;
      normal[0]          = nearest.normal[0];
      normal[1]          = nearest.normal[1];
      touch.feature      = nearest.tooth_gap;
    }
  if (touch.gap < 0.)
    {
      touch.normal = master.rotation * normal;
      touch.point  = family_.at_centres ? x : x - radius * touch.normal;
      set_tangents(touch, master);
    }
  return touch;
}

bool RigidFlanks::is_near(const World                &world,
                          const dealii::Tensor<1, 3> &x,
                          const double                radius,
                          const double                reach) const
{
  const Frame               &sprocket = world.frames[body()];
  const dealii::Tensor<1, 3> z        = axis_of(sprocket, 2);
  dealii::Tensor<1, 3>       offset   = x - sprocket.position;
  offset -= (offset * z) * z;
  return offset.norm() < family_.outer_radius + radius + reach;
}

bool RigidFlanks::is_beside(const World &world, const dealii::Tensor<1, 3> &x) const
{
  const Frame &sprocket = world.frames[body()];
  return std::abs(axis_of(sprocket, 2) * (x - sprocket.position) - family_.z) > family_.half_width;
}
} // namespace chaindrive::contact
