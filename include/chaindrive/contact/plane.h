// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface.h>

#include <deal.II/base/point.h>

namespace chaindrive::contact
{
/// A plane of a rigid body that goes on for ever. The springs of closed contacts, for the critical
/// time step, take it to hold the body's z direction.
class Plane : public Surface
{
public:
  /// Through @p point [m], with the unit @p normal out of the material; both in the frame of @p
  /// body.
  Plane(const unsigned int body, const dealii::Point<3> &point, const dealii::Tensor<1, 3> &normal)
      : Surface(body), point_(point), normal_(normal)
  {
  }

  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                const double                radius,
                double /*within*/,
                unsigned int & /*hint*/,
                Projection & /*projection*/) const override
  {
    const Frame               &frame  = world.frames[body()];
    const dealii::Tensor<1, 3> normal = frame.rotation * normal_;

    Touch touch;
    touch.gap = (x - to_world(frame, point_)) * normal - radius;
    if (touch.gap < 0.)
      {
        touch.normal = normal;
        touch.point  = x - radius * normal;
        set_tangents(touch, frame);
      }
    return touch;
  }

private:
  dealii::Point<3>     point_;
  dealii::Tensor<1, 3> normal_;
};
} // namespace chaindrive::contact
