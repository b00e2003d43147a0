// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/tooth_side.h>

#include <cmath>

namespace chaindrive::contact
{
ToothSide::ToothSide(const scene::ToothSideFamily &family, const int sign)
    : Surface(family.sprocket)
    , sign_(sign)
    , z_(family.z)
    , half_width_(family.half_width)
    , from_(family.tip_radius - std::sqrt(family.relief * (2. * family.radius - family.relief)))
    , radius_(family.radius)
{
}

double ToothSide::distance(const dealii::Tensor<1, 3> &local, dealii::Tensor<1, 3> &normal) const
{
  const double z    = local[2] - z_;
  const int    sign = sign_ != 0 ? sign_ : z < 0. ? -1 : 1;
  const double r = std::hypot(local[0], local[1]), above = sign * z - half_width_;
  normal = dealii::Tensor<1, 3>();
  if (r <= from_)
    {
      normal[2] = sign;
      return above;
    }
  const double out = r - from_, up = above + radius_, from_centre = std::hypot(out, up);
  normal[0] = out / from_centre * local[0] / r;
  normal[1] = out / from_centre * local[1] / r;
  normal[2] = sign * up / from_centre;
  return from_centre - radius_;
}

Touch ToothSide::project(const World                &world,
                         const dealii::Tensor<1, 3> &x,
                         const double                radius,
                         double /*within*/,
                         unsigned int & /*hint*/,
                         Projection & /*projection*/) const
{
  const Frame         &master = world.frames[body()];
  dealii::Tensor<1, 3> normal;
  Touch                touch;
  touch.gap = distance(dealii::transpose(master.rotation) * (x - master.position), normal) - radius;
  if (touch.gap < 0.)
    {
      touch.normal = master.rotation * normal;
      touch.point  = x - radius * touch.normal;
      touch.along  = dealii::cross_product_3d(axis_of(master, 1), touch.normal);
      touch.along /= touch.along.norm();
      touch.across = dealii::cross_product_3d(touch.normal, touch.along);
    }
  return touch;
}

bool ToothSide::is_near(const World                &world,
                        const dealii::Tensor<1, 3> &x,
                        const double                radius,
                        const double                reach) const
{
  const Frame         &master = world.frames[body()];
  dealii::Tensor<1, 3> normal;
  return distance(dealii::transpose(master.rotation) * (x - master.position), normal) <
         radius + reach;
}
} // namespace chaindrive::contact
