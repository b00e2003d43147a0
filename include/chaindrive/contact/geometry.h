// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/rotation.h>

#include <cmath>
#include <limits>

namespace chaindrive::contact
{
/// Where a slave point with a radius is nearest to a surface.
struct Touch
{
  double               gap = std::numeric_limits<double>::max(); ///< m, negative: penetration
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
} // namespace chaindrive::contact
