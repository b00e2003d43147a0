// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/path/obstacle.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <vector>

namespace chaindrive::path
{
/// The line of a guide in the plane, with the material on one side of it: what is nearest to a
/// point on it, and on which side the point is. Lengths in m.
class Curve
{
public:
  /// The circle through three @p points, from the first to the last one.
  static Curve arc(const std::vector<dealii::Point<2>> &points);

  /// The natural cubic spline through at least two @p points, over the lengths of their chords [de
  /// Boor 1978]. Two points make a straight line.
  static Curve spline(const std::vector<dealii::Point<2>> &points);

  /// Moves all of it.
  void move(const dealii::Tensor<1, 2> &by);

  /// Puts the material on the other side.
  void reverse() { side_ = -side_; }

  /// The distance of @p p from the line, negative on the side of the material, and the normal from
  /// its nearest point to @p p, or on that side from p to it. Beyond the ends there is no material.
  /// @p hint, where the last search has ended, makes the next one short; any number will do.
  Nearest nearest(const dealii::Point<2> &p, unsigned int &hint) const;

  /// Of its two ends.
  dealii::Point<2> begin() const { return at(0.); }
  dealii::Point<2> end() const { return at(static_cast<double>(pieces_.size())); }

  double length() const;

  /// At @p s from 0 to n_pieces().
  dealii::Point<2> at(double s) const;
  unsigned int     n_pieces() const { return static_cast<unsigned int>(pieces_.size()); }

private:
  /// A cubic p(t) = a + b t + c t^2 + d t^3 for 0 <= t <= 1.
  struct Piece
  {
    dealii::Tensor<1, 2> a, b, c, d;
  };

  std::vector<Piece> pieces_;
  double             side_ = 1.; ///< +1: there is material to the right
};
} // namespace chaindrive::path
