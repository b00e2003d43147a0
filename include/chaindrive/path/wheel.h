// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

/// The way of a chain round its wheels: which joints sit where. Lengths in m, angles in rad. Link k
/// joins joints k and k + 1; links of even number are inner links.
namespace chaindrive::path
{
/// Distances of consecutive bushes.
struct LinkLengths
{
  double inner, outer;

  double of(const unsigned int link) const { return link % 2 == 0 ? inner : outer; }
  double mean() const { return 0.5 * (inner + outer); }

  /// Length of @p n links, the first of which is number @p first.
  double sum(unsigned int first, unsigned int n) const;
};

/// A wheel with the bushes of a chain on it. The chain runs round it counter-clockwise (turn = 1)
/// or clockwise (-1), inside or outside of its loop. Bush k of a seat at the polar angle g is at g
/// + turn shift for even k, g - turn shift for odd k, on the circle of radius bush_radius, so that
/// consecutive bushes have exactly the distances of inner and outer links.
struct Wheel
{
  unsigned int     teeth; ///< 0: none
  int              turn;
  dealii::Point<2> centre;
  double           pitch_angle;   ///< between consecutive seats
  double           roller_radius; ///< of the circle of the seats: mean / (2 sin(pitch_angle / 2))
  double           bush_radius;
  double           shift;

  /// A sprocket with @p n_teeth seats on a whole turn.
  Wheel(unsigned int            n_teeth,
        const dealii::Point<2> &position,
        const LinkLengths      &lengths,
        int                     turns = 1);

  /// A wheel without teeth, on which rollers lie on a circle of radius @p seats, more than half the
  /// mean length, wherever the chain puts them.
  static Wheel
  flat(double seats, const dealii::Point<2> &position, const LinkLengths &lengths, int turns = 1);

  dealii::Point<2> roller(double seat) const;
  dealii::Point<2> bush(double seat, unsigned int joint) const;

  /// The seat @p links further in the direction of travel; before it, where that is negative.
  double after(const double seat, const int links) const
  {
    return seat + turn * (links * pitch_angle);
  }

  /// Direction angle of travel at the polar angle @p angle.
  double direction(double angle) const;

private:
  Wheel() = default;

  /// All but the circle of the seats, of which @p half is half the pitch angle.
  void set(const dealii::Point<2> &position, const LinkLengths &lengths, int turns, double half);
};
} // namespace chaindrive::path
