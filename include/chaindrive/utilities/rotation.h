// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <cmath>

namespace chaindrive
{
/// Unit quaternion w + (x, y, z): the rotation that carries body axes to world axes.
struct Quaternion
{
  double w = 1., x = 0., y = 0., z = 0.;
};

/// Quaternion product a b: first rotate by b, then by a.
inline Quaternion operator*(const Quaternion &a, const Quaternion &b)
{
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
          a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// The same rotation with its length, which round-off lets drift, set back to one.
inline Quaternion normalized(const Quaternion &q)
{
  const double s = 1. / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * s, q.x * s, q.y * s, q.z * s};
}

/// Rotation by the vector @p angle: about its direction, by its length [rad] (exponential map).
inline Quaternion rotation_by(const dealii::Tensor<1, 3> &angle)
{
  const double square = angle * angle;
  // sin(|a|/2)/|a| and cos(|a|/2); below 1e-3 rad the series is exact to round-off
  double s, c;
  if (square < 1e-6)
    {
      s = 0.5 - square / 48. + square * square / 3840.;
      c = 1. - square / 8. + square * square / 384.;
    }
  else
    {
      const double length = std::sqrt(square);
      s                   = std::sin(0.5 * length) / length;
      c                   = std::cos(0.5 * length);
    }
  return {c, s * angle[0], s * angle[1], s * angle[2]};
}

/// Rotation about the z axis by @p angle [rad], counter-clockwise seen from +z.
inline Quaternion rotation_about_z(const double angle)
{
  return {std::cos(0.5 * angle), 0., 0., std::sin(0.5 * angle)};
}

/// The rotation matrix R of @p q: world vector = R body vector.
inline dealii::Tensor<2, 3> to_matrix(const Quaternion &q)
{
  dealii::Tensor<2, 3> r;
  r[0][0] = 1. - 2. * (q.y * q.y + q.z * q.z);
  r[0][1] = 2. * (q.x * q.y - q.w * q.z);
  r[0][2] = 2. * (q.x * q.z + q.w * q.y);
  r[1][0] = 2. * (q.x * q.y + q.w * q.z);
  r[1][1] = 1. - 2. * (q.x * q.x + q.z * q.z);
  r[1][2] = 2. * (q.y * q.z - q.w * q.x);
  r[2][0] = 2. * (q.x * q.z - q.w * q.y);
  r[2][1] = 2. * (q.y * q.z + q.w * q.x);
  r[2][2] = 1. - 2. * (q.x * q.x + q.y * q.y);
  return r;
}

/// The quaternion of the rotation matrix @p r, by Shepperd's method: the largest of the four
/// components is found first, so that nothing is divided by a small number.
inline Quaternion to_quaternion(const dealii::Tensor<2, 3> &r)
{
  const double trace = r[0][0] + r[1][1] + r[2][2];
  Quaternion   q;
  if (trace > 0.)
    q = {1. + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
  else if (r[0][0] >= r[1][1] && r[0][0] >= r[2][2])
    q = {r[2][1] - r[1][2], 1. + r[0][0] - r[1][1] - r[2][2], r[0][1] + r[1][0], r[0][2] + r[2][0]};
  else if (r[1][1] >= r[2][2])
    q = {r[0][2] - r[2][0], r[0][1] + r[1][0], 1. - r[0][0] + r[1][1] - r[2][2], r[1][2] + r[2][1]};
  else
    q = {r[1][0] - r[0][1], r[0][2] + r[2][0], r[1][2] + r[2][1], 1. - r[0][0] - r[1][1] + r[2][2]};
  return normalized(q);
}

/// Where a body is and how it moves at one instant: world point = position + rotation * body point.
struct Frame
{
  dealii::Tensor<1, 3> position;         ///< of the body's origin, m
  dealii::Tensor<2, 3> rotation;         ///< body axes to world axes
  dealii::Tensor<1, 3> velocity;         ///< of the body's origin, m/s
  dealii::Tensor<1, 3> angular_velocity; ///< in world axes, rad/s
};
} // namespace chaindrive
