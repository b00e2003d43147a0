// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cmath>

namespace chaindrive::path
{
/// The point of an outline that is nearest to a given point.
struct Nearest
{
  double               distance; ///< m, positive outside of the metal, negative inside
  dealii::Tensor<1, 2> normal;   ///< unit, out of the metal
};

/// What a chain cannot go through: an outline in the plane, in a frame of its own.
class Obstacle
{
public:
  virtual ~Obstacle() = default;

  /// Radius about the origin of its frame beyond which there is nothing of it, m.
  virtual double reach() const = 0;

  virtual Nearest nearest(const dealii::Point<2> &p) const = 0;
};

/// A disc about the origin: a wheel without teeth.
class Disc : public Obstacle
{
public:
  explicit Disc(const double radius) : radius_(radius) {}

  double  reach() const override { return radius_; }
  Nearest nearest(const dealii::Point<2> &p) const override
  {
    const double         r = std::hypot(p[0], p[1]);
    dealii::Tensor<1, 2> normal;
    normal[0] = r > 0. ? p[0] / r : 1.;
    normal[1] = r > 0. ? p[1] / r : 0.;
    return {r - radius_, normal};
  }

private:
  double radius_; ///< m
};
} // namespace chaindrive::path
