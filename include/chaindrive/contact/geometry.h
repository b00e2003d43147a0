// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/scene/interface.h>
#include <chaindrive/utilities/rotation.h>

#include <cmath>
#include <limits>

namespace chaindrive::contact
{
/// Where a slave point with a radius is nearest to a smooth master surface.
struct Touch
{
  double               gap = std::numeric_limits<double>::max(); ///< m, negative: overlap
  dealii::Tensor<1, 3> normal;      ///< unit, away from the master's material, world axes
  dealii::Tensor<1, 3> point;       ///< on the slave's surface, world, m
  dealii::Tensor<1, 3> along;       ///< unit tangent in the plane normal to the master's z axis
  dealii::Tensor<1, 3> across;      ///< unit tangent, completing the triad
  unsigned int         feature = 0; ///< of the master: the gap between two teeth, or the facet
};

/// World position of the body point @p p.
inline dealii::Tensor<1, 3> to_world(const Frame &frame, const dealii::Tensor<1, 3> &p)
{
  return frame.position + frame.rotation * p;
}

/// Axis @p d of a body in the world.
inline dealii::Tensor<1, 3> axis_of(const Frame &frame, const unsigned int d)
{
  dealii::Tensor<1, 3> axis;
  for (unsigned int i = 0; i < 3; ++i)
    axis[i] = frame.rotation[i][d];
  return axis;
}

/// Sets the tangents of @p touch: the first in the plane normal to the master's z axis, round a
/// bore or along a tooth; on a surface that faces z, in the plane normal to its y axis. Both turn
/// with the master, so that a sticking contact keeps its elastic slip.
inline void set_tangents(Touch &touch, const Frame &master)
{
  touch.along          = dealii::cross_product_3d(axis_of(master, 2), touch.normal);
  double length_square = touch.along.norm_square();
  if (length_square < 0.01)
    {
      touch.along   = dealii::cross_product_3d(axis_of(master, 1), touch.normal);
      length_square = touch.along.norm_square();
    }
  touch.along /= std::sqrt(length_square);
  touch.across = dealii::cross_product_3d(touch.normal, touch.along);
}

/// A slave of radius r whose axis passes a bore of radius R at the distance e from the bore's axis:
/// gap = R - r - e. Cylinder in cylinder, exact for parallel axes.
inline Touch touch_bore(const scene::BorePair &pair, const Frame &master, const Frame &slave)
{
  const dealii::Tensor<1, 3> z      = axis_of(master, 2);
  const dealii::Tensor<1, 3> centre = to_world(slave, pair.slave.point);
  dealii::Tensor<1, 3>       offset = centre - to_world(master, pair.axis);
  offset -= (offset * z) * z;
  const double square    = offset.norm_square();
  const double clearance = pair.radius - pair.slave.radius;

  Touch touch;
  touch.gap = clearance - std::sqrt(square);
  if (touch.gap < 0. && square > 0.)
    {
      touch.normal = offset / -std::sqrt(square);
      touch.point  = centre - pair.slave.radius * touch.normal;
      set_tangents(touch, master);
    }
  return touch;
}
} // namespace chaindrive::contact
