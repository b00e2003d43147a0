// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface.h>

namespace chaindrive::contact
{
/// A flat face of a rigid body across its z axis, without an edge: of a plate about a joint, whose
/// partner stays beside it.
class FlatSide final : public Surface
{
public:
  /// The face of @p body at @p z [m], which looks towards z if @p sign is +1, against it if -1.
  FlatSide(const unsigned int body, const double z, const int sign)
      : Surface(body), z_(z), sign_(sign)
  {
  }

  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                double /*radius*/,
                double /*within*/,
                unsigned int & /*hint*/,
                Projection & /*projection*/) const override
  {
    Touch touch;
    project(world, x, touch);
    return touch;
  }

  /// The same into @p touch, of which only the gap is set where there is no penetration.
  void project(const World &world, const dealii::Tensor<1, 3> &x, Touch &touch) const
  {
    const Frame               &master = world.frames[body()];
    const dealii::Tensor<1, 3> z      = axis_of(master, 2);
    touch.gap                         = sign_ * (z * (x - master.position) - z_);
    if (touch.gap < 0.)
      {
        touch.normal = sign_ * z;
        touch.point  = x;
        touch.along  = axis_of(master, 0);
        touch.across = dealii::cross_product_3d(touch.normal, touch.along);
      }
  }

  Facing facing() const override { return Facing::along_axis; }

private:
  double z_;
  int    sign_;
};
} // namespace chaindrive::contact
