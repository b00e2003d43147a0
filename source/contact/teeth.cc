// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/family.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/mesh/surface/facet_surface.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
namespace
{
/// The gap between two teeth that the point @p p of the sprocket's frame is nearest to.
unsigned int gap_of(const dealii::Tensor<1, 3> &p, const unsigned int teeth)
{
  const double gaps = std::atan2(p[1], p[0]) * teeth / (2. * dealii::numbers::PI);
  return (static_cast<int>(std::lround(gaps)) + teeth) % teeth;
}

} // namespace

Touch touch_flanks(const scene::ToothFamily   &family,
                   const dealii::Tensor<1, 3> &centre,
                   const double                radius,
                   const double                within,
                   const Frame                &master,
                   unsigned int               &hint)
{
  const dealii::Tensor<1, 3> local =
      dealii::transpose(master.rotation) * (centre - master.position);

  Touch                touch;
  dealii::Tensor<1, 3> normal;
  if (family.facets)
    {
      const double z = std::clamp(local[2], -family.half_width, family.half_width);
      const auto   nearest =
          family.facets->closest_point(dealii::Point<3>(local[0], local[1], z), within, hint);
      if (!nearest.found)
        return touch;
      touch.gap = nearest.distance - radius;
      normal    = nearest.normal;
      hint      = nearest.facet;
      if (touch.gap < 0.)
        touch.feature = gap_of(local, family.teeth);
    }
  else
    {
      const auto nearest = family.form->closest_point(dealii::Point<2>(local[0], local[1]));
      touch.gap          = nearest.distance - radius;
      normal[0]          = nearest.normal[0];
      normal[1]          = nearest.normal[1];
      touch.feature      = nearest.tooth_gap;
    }
  if (touch.gap < 0.)
    {
      touch.normal = master.rotation * normal;
      touch.point  = centre - radius * touch.normal;
      set_tangents(touch, master);
    }
  return touch;
}

Teeth::Teeth(const scene::ToothFamily &scene) : Family(scene.name, scene.law), scene_(scene)
{
  for (const scene::SlavePoint &slave : scene_.slaves)
    {
      add_radius(slave.radius);
      add_record(scene_.sprocket, slave.body, slave.joint);
    }
  states_.resize(records_.size());
  hints_.assign(records_.size(), mesh::Projection::no_facet);
}

void Teeth::search(const World &world, const double reach)
{
  near_.clear();
  const Frame &sprocket = world.frames[scene_.sprocket];
  for (unsigned int i = 0; i < scene_.slaves.size(); ++i)
    {
      const scene::SlavePoint &slave = scene_.slaves[i];
      dealii::Tensor<1, 3>     offset =
          to_world(world.frames[slave.body], slave.point) - sprocket.position;
      offset -= (offset * axis_of(sprocket, 2)) * axis_of(sprocket, 2);
      if (offset.norm() < scene_.outer_radius + slave.radius + reach)
        near_.push_back(i);
      else
        records_[i].gap = std::numeric_limits<double>::max();
    }
}

void Teeth::serialize(const Archive &archive, const unsigned int rank)
{
  Family::serialize(archive, rank);
  archive("near", near_);
  archive.numbers("hints", hints_);
}

void Teeth::add_forces(World &world, const double dt)
{
  const Frame &sprocket = world.frames[scene_.sprocket];
  for (const unsigned int i : near_)
    {
      const scene::SlavePoint   &slave  = scene_.slaves[i];
      const dealii::Tensor<1, 3> centre = to_world(world.frames[slave.body], slave.point);
      Touch                      touch;
      if (std::abs(axis_of(sprocket, 2) * (centre - sprocket.position)) <= scene_.half_width)
        touch = touch_flanks(scene_, centre, slave.radius, 2. * slave.radius, sprocket, hints_[i]);
      apply(world, i, touch, dt);
    }
}

void Teeth::add_springs(const World &world, std::vector<Spring> &springs) const
{
  const Mobility             mobility(world);
  const Frame               &sprocket = world.frames[scene_.sprocket];
  const dealii::Tensor<1, 3> z        = axis_of(sprocket, 2);
  for (const unsigned int i : near_)
    {
      const scene::SlavePoint &slave  = scene_.slaves[i];
      dealii::Tensor<1, 3>     centre = to_world(world.frames[slave.body], slave.point);
      dealii::Tensor<1, 3>     radial = centre - sprocket.position;
      radial -= (radial * z) * z;
      add_closed(world, mobility, i, radial / radial.norm(), centre, slave.radius, springs);
    }
}
} // namespace chaindrive::contact
