// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/stiffness_curve.h>

#include <vector>

namespace chaindrive::drive
{
/// What has been found of a contact at one place: each force with its approach.
struct Approaches
{
  double              place = 0.; ///< see StiffnessCurve
  std::vector<double> force;      ///< N, ascending
  std::vector<double> approach;   ///< m, ascending
};

/// The curve with the least squares of relative errors of the force at each of @p places: one, or
/// two or three of which the first is 0 and the last the end. Its depth is that of the approaches
/// at the first of them with which the squares are least; its unit and bottom are left to be set.
///
/// With @p with_tangents the squares contain the relative errors of the tangents at all forces but
/// the first and the last of each place, and the depth is any between the smallest and the largest
/// approach at the first place. What vibrates under a load feels the tangent there, which is up to
/// 9 % too large where only forces are fitted and the depth is at the load.
///
/// Where a fit has no positive stiffness, or polynomials have none between the places, the secant
/// of the largest force stands at each place, and lines between the first and the last.
/// @throws std::logic_error for other numbers of places, or less than two forces at one of them.
StiffnessCurve fit_stiffness(const std::vector<Approaches> &places, bool with_tangents = false);

/// The force [N] of @p curve at a @p place for an @p approach [m] that is not negative.
double force_of(const StiffnessCurve &curve, double place, double approach);

/// The approach [m] with which @p curve has this @p force [N], which is not negative, at a @p
/// place.
double approach_of(const StiffnessCurve &curve, double place, double force);

/// The largest tangent stiffness of @p curve at all of its places and approaches, N/m.
double stiffest(const StiffnessCurve &curve);
} // namespace chaindrive::drive
