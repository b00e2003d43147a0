// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface.h>

namespace chaindrive::contact
{
/// The outside of a cylinder round the z axis of a rigid body.
class Drum : public Surface
{
public:
  /// @p radius of the cylinder, m.
  Drum(const unsigned int body, const double radius) : Surface(body), radius_(radius) {}

  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                const double                radius,
                double /*within*/,
                unsigned int & /*hint*/,
                Projection & /*projection*/) const override
  {
    const Frame               &frame  = world.frames[body()];
    const dealii::Tensor<1, 3> z      = axis_of(frame, 2);
    dealii::Tensor<1, 3>       offset = x - frame.position;
    offset -= (offset * z) * z;
    const double distance = offset.norm();

    Touch touch;
    touch.gap = distance - radius_ - radius;
    if (touch.gap < 0. && distance > 0.)
      {
        touch.normal = offset / distance;
        touch.point  = x - radius * touch.normal;
        set_tangents(touch, frame);
      }
    return touch;
  }

private:
  double radius_;
};
} // namespace chaindrive::contact
