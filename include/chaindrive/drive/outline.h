// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace chaindrive::drive
{
/// The third component of the cross product of two vectors in the plane.
inline double cross(const dealii::Tensor<1, 2> &a, const dealii::Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// An arc or a straight piece of a plane outline of solid material, run through from begin to end.
///
/// For an arc, point(t) = centre + radius (cos a, sin a) with the angle a running linearly from
/// begin_angle to end_angle, upwards or downwards. Outlines are run through counter-clockwise, the
/// material on their left; an arc with end_angle > begin_angle therefore is convex (its centre lies
/// on the side of the material), one with end_angle < begin_angle is concave.
struct Segment
{
  enum class Kind
  {
    line,
    convex,
    concave
  };

  Kind                 kind;
  dealii::Point<2>     begin, end;
  dealii::Point<2>     centre;      ///< of arcs
  double               radius;      ///< of arcs, m
  double               begin_angle; ///< of arcs, rad
  double               end_angle;   ///< of arcs, rad
  dealii::Tensor<1, 2> middle;      ///< unit, of arcs: from the centre to the middle of the arc
  double               half_cosine; ///< of arcs: cosine of half of its angle

  /// The point at the fraction @p t of the segment, 0 <= t <= 1.
  dealii::Point<2> point(double t) const;

  double length() const;

  /// This segment's share of the enclosed area, 1/2 int x dy - y dx. [m2]
  double area() const;

  /// This segment's share of the polar second moment of area about the origin, 1/4 int r^2 (x dy -
  /// y dx). [m4]
  double polar_moment() const;

  /// This segment's share of int y^2 dA = -1/3 int y^3 dx. [m4]
  double moment_about_x() const;
};

/// The straight segment from @p begin to @p end.
Segment line_segment(const dealii::Point<2> &begin, const dealii::Point<2> &end);

/// The arc about @p centre from @p begin_angle to @p end_angle [rad].
Segment
arc_segment(const dealii::Point<2> &centre, double radius, double begin_angle, double end_angle);
} // namespace chaindrive::drive
