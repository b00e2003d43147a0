// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/numbers.h>

#include <vector>

namespace chaindrive::contact
{
/// A round side of modal bodies in contact without penalty. Where a window of it is closed and what
/// it meets stands still, it holds the modes by the inverse of its own flexibility.
struct ClosedWindow
{
  unsigned int              group     = 0; ///< of the bodies in World::copies
  unsigned int              surface   = 0; ///< of their mesh
  unsigned int              n_columns = 0, n_rings = 0;
  std::vector<unsigned int> node;        ///< [ring][column], column c at the angle 2 pi c / n
  std::vector<double>       flexibility; ///< [ring][ring][columns between], m/N
  std::vector<double> across; ///< [ring]: springs of friction across the normal of a node, N/m
  double              half_angle = dealii::numbers::PI; ///< of the window, rad

  double across_middle = 0.; ///< one spring of friction across the window's middle, N/m

  unsigned int first_ring = 0; ///< of the side, if not all of them are in the window

  /// Of the outside of a roller, whose wall couples it with the bore: the flexibility between the
  /// two, [ring][ring of the whole bore][columns between], m/N. Else empty.
  std::vector<double> through            = {};
  unsigned int        n_rings_of_through = 0;
};

/// What families of contact without penalty are besides.
class HasClosedWindows
{
public:
  virtual ~HasClosedWindows() = default;

  /// Both sides of all kinds of pairs, for the critical time step; none of those with penalty.
  virtual std::vector<ClosedWindow> closed_windows() const = 0;
};
} // namespace chaindrive::contact
