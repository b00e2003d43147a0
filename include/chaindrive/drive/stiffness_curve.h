// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// No headers here: the kernels that are compiled for several instruction sets include this one, see
// utilities/pack.h.

namespace chaindrive::drive
{
/// Force over approach of a contact that is stiffer the more it bears, and on teeth softer the
/// higher up it is. The tangent stiffness grows, or falls, linearly with the approach from `first`
/// to `last` at `depth`, and stays so:
///   F(d) = first d + (last - first) / (2 depth) (d^2 - max(0, d - depth)^2).
/// On teeth `first` and `last` are polynomials of second degree of the place, the height of the
/// point of contact above the bottom of the tooth gap over #unit, up to #end; beyond, all is as
/// there. At every place F is the derivative of an energy, and along the tooth that has another.
struct StiffnessCurve
{
  double first[3], last[3]; ///< coefficients of the powers of the place, N/m
  double depth;             ///< m
  double bottom = 0.;       ///< distance of the bottom of the gap from the sprocket's axis, m
  double unit   = 1.;       ///< of heights above it, m
  double end    = 0.;       ///< place; 0: there is only one
};
} // namespace chaindrive::drive
