// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface.h>

#include <deal.II/base/point.h>

namespace chaindrive::contact
{
/// The inside of a cylinder round the z direction of a rigid body. A slave of radius r whose axis
/// passes at the distance e from the bore's axis has the gap R - r - e: cylinder in cylinder, exact
/// for parallel axes.
class Bore final : public Surface
{
public:
  /// @p axis is a point of the bore's axis in the frame of @p body, @p radius R that of the bore,
  /// m.
  Bore(const unsigned int body, const dealii::Point<3> &axis, const double radius)
      : Surface(body), axis_(axis), radius_(radius)
  {
  }

  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                const double                radius,
                double /*within*/,
                unsigned int & /*hint*/,
                Projection & /*projection*/) const override
  {
    Touch touch;
    project(world, x, radius, touch);
    return touch;
  }

  /// The same into @p touch, of which only the gap is set where there is no penetration: a Touch
  /// that is made anew for each slave costs as much as the rest.
  void project(const World                &world,
               const dealii::Tensor<1, 3> &x,
               const double                radius,
               Touch                      &touch) const
  {
    const Frame               &master = world.frames[body()];
    const dealii::Tensor<1, 3> z      = axis_of(master, 2);
    dealii::Tensor<1, 3>       offset = x - to_world(master, axis_);
    offset -= (offset * z) * z;
    const double square    = offset.norm_square();
    const double clearance = radius_ - radius;

    touch.gap = clearance - std::sqrt(square);
    if (touch.gap < 0. && square > 0.)
      {
        touch.normal = offset / -std::sqrt(square);
        touch.point  = x - radius * touch.normal;
        set_tangents(touch, master);
      }
  }

  /// Along the slave, which is a link of the chain or one of its rollers: most of the force is.
  dealii::Tensor<1, 3> main_direction(const World &,
                                      const Frame &slave,
                                      const dealii::Tensor<1, 3> & /*centre*/) const override
  {
    return axis_of(slave, 0);
  }

private:
  dealii::Point<3> axis_;
  double           radius_;
};
} // namespace chaindrive::contact
