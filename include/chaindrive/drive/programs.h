// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/functions/function.h>
#include <chaindrive/parameters/parameters.h>

namespace chaindrive::drive
{
/// What a shaft is given, in the sense in which its sprocket turns in operation: a speed, or a
/// torque that resists it, a function of its angle times one of time plus another of time. Without
/// anything else it turns freely.
struct ShaftProgram
{
  functions::Pointer speed;        ///< over time [s], rad/s; null: it turns as it is made to
  functions::Pointer torque;       ///< over the angle turned since the start [rad], N m
  functions::Pointer torque_share; ///< over time [s], by which #torque is multiplied
  functions::Pointer torque_added; ///< over time [s], N m

  ShaftProgram();

  /// N m, after it has @p turned [rad] since the start, at @p time [s].
  double resisting_torque(const double turned, const double time) const
  {
    return torque->value(turned) * torque_share->value(time) + torque_added->value(time);
  }

  /// The time [s], not before @p start, of the last breakpoint of what is a function of time.
  double last_change(double start) const;
};

/// That of a sprocket of this @p role from the time @p start [s] on. With @p settled the driver has
/// its full speed from the start, and all of the torque acts whichever way the driven sprocket
/// turns; else the speed grows over the ramp's time, and the torque over the ramp's angle.
ShaftProgram
make_program(parameters::Role role, const parameters::Loads &loads, double start, bool settled);
} // namespace chaindrive::drive
