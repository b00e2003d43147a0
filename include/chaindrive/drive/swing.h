// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/layout.h>
#include <chaindrive/functions/function.h>
#include <chaindrive/parameters/parameters.h>

#include <deal.II/base/point.h>

#include <string>

namespace chaindrive::drive
{
/// How the axis of a wheel moves about a pivot, whatever pulls at it.
struct Swing
{
  dealii::Point<2>   pivot;     ///< m
  functions::Pointer angle;     ///< over time [s]: of the arm, counter-clockwise, rad
  std::string        file = {}; ///< that was read for it; empty: none

  double least = 0., most = 0.; ///< of the turn since the start during the run, rad

  /// Where an axis that is at @p start [m] is after the arm has @p turned [rad].
  dealii::Point<2> centre(const dealii::Point<2> &start, double turned) const;
};

/// That of wheel number @p i, which has one, of a drive with this @p layout. InputError naming the
/// entry where it cannot be.
Swing make_swing(const Parameters &parameters, unsigned int i, const Layout &layout);

/// A sentence that says how far wheel number @p i moves during the run, and what that does to its
/// distances from the wheels before and behind it.
std::string in_words(const Swing                 &swing,
                     const parameters::Sprockets &wheels,
                     unsigned int                 i,
                     const Layout                &layout);
} // namespace chaindrive::drive
