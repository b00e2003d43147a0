// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/functions/terms.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// What a shaft is given, in the sense in which its sprocket turns in operation: a speed, or a
/// torque that resists it. That is a function of its angle and several terms, times one of time,
/// plus another of time, all times the share of a strand. Without anything else it turns freely.
struct ShaftProgram
{
  functions::Pointer speed;        ///< over time [s], rad/s; null: it turns as it is made to
  functions::Pointer run_up;       ///< how #speed grows, without what comes later and fluctuations
  functions::Pointer torque;       ///< over the angle turned since the start [rad], N m
  functions::Pointer torque_share; ///< over time [s], by which #torque and #terms are multiplied
  functions::Pointer torque_added; ///< over time [s], N m
  functions::Pointer growth;       ///< over the angle, by which terms of the angle are multiplied
  double             share = 1.;   ///< of the torque that one strand takes
  std::vector<functions::Term> terms; ///< of the torque
  std::vector<std::string>     files; ///< that were read for it

  ShaftProgram();

  /// N m, after it has @p turned [rad] since the start, at @p time [s] with the @p speed [rad/s].
  double resisting_torque(const double turned, const double time, const double speed) const
  {
    return lasting_torque(turned, time, speed) * torque_share->value(time) +
           share * torque_added->value(time);
  }

  /// The same of a torque that does not step.
  double lasting_torque(double turned, double time, double speed) const;

  /// Its mean in operation at the mean @p speed [rad/s] between the times @p start and @p end [s].
  double mean_torque(double start, double end, double speed) const;

  /// A bound of its magnitude.
  double largest_torque(double start, double end, double speed) const;

  /// The time [s], not before @p start, of the last breakpoint of what is a function of time.
  double last_change(double start) const;
};

/// That of @p sprocket from the time @p start [s] on. With @p settled the driver has its full speed
/// from the start, and all of the torque acts whichever way the driven sprocket turns; else the
/// speed grows over the ramp's time, and the torque over the ramp's angle. Tables are looked for in
/// @p folders. One strand takes @p share of torques. InputError as functions::make_terms().
ShaftProgram make_program(const parameters::Sprocket     &sprocket,
                          const parameters::Loads        &loads,
                          double                          start,
                          bool                            settled,
                          const std::vector<std::string> &folders = {"."},
                          double                          share   = 1.);
} // namespace chaindrive::drive
