// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/functions/function.h>
#include <chaindrive/parameters/parameters.h>

namespace chaindrive::drive
{
/// What is prescribed to the shafts, in the sense of the drive: the speed of the driver, and the
/// torque that resists the driven sprocket, a function of its angle times one of time plus another
/// of time. Without anything else the drive stands still and no torque acts.
struct Programs
{
  functions::Pointer speed;        ///< of the driver over time [s], rad/s
  functions::Pointer torque;       ///< over the angle turned since the start [rad], N m
  functions::Pointer torque_share; ///< over time [s], by which #torque is multiplied
  functions::Pointer torque_added; ///< over time [s], N m

  Programs();

  /// N m, after the driven sprocket has @p turned [rad] since the start, at @p time [s].
  double resisting_torque(const double turned, const double time) const
  {
    return torque->value(turned) * torque_share->value(time) + torque_added->value(time);
  }

  /// The time [s], not before @p start, of the last breakpoint of what is a function of time.
  double last_change(double start) const;
};

/// Those of @p loads from the time @p start [s] on. With @p settled the driver has its full speed
/// from the start, and all of the torque acts whichever way the driven sprocket turns; else the
/// speed grows over the ramp's time, and the torque over the ramp's angle.
Programs make_programs(const parameters::Loads &loads, double start, bool settled);
} // namespace chaindrive::drive
