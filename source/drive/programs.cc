// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/programs.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace chaindrive::drive
{
namespace
{
functions::Pointer constant(const double value)
{
  return std::make_shared<functions::Constant>(value);
}

/// Another value from the time @p place on.
functions::Pointer step(const double before, const double place, const double after)
{
  return std::make_shared<functions::Steps>(
      before, std::vector<double>{place}, std::vector<double>{after});
}
} // namespace

ShaftProgram::ShaftProgram()
    : torque(constant(0.)), torque_share(constant(1.)), torque_added(constant(0.))
{
}

double ShaftProgram::last_change(const double start) const
{
  double last = start;
  for (const functions::Pointer &of_time : {speed, torque_share, torque_added})
    if (of_time)
      last = std::max(last, functions::last_breakpoint(*of_time, start));
  return last;
}

ShaftProgram make_program(const parameters::Role   role,
                          const parameters::Loads &loads,
                          const double             start,
                          const bool               settled)
{
  using functions::Ramp;
  ShaftProgram program;
  switch (role)
    {
    case parameters::Role::driver:
      program.speed = std::make_shared<Ramp>(loads.driver_speed,
                                             start,
                                             settled ? 0. : loads.ramp_time,
                                             loads.speed_ramp == parameters::SpeedRamp::cosine ?
                                                 functions::Rise::cosine :
                                                 functions::Rise::linear);
      break;
    case parameters::Role::driven:
      if (settled)
        program.torque = constant(loads.resisting_torque);
      else
        program.torque =
            std::make_shared<Ramp>(loads.resisting_torque, 0., loads.torque_ramp_angle);
      if (loads.torque_step_time)
        {
          const double time    = start + *loads.torque_step_time;
          program.torque_share = step(1., time, 0.);
          program.torque_added = step(0., time, loads.torque_after_step);
        }
      break;
    case parameters::Role::idler:
      break;
    }
  return program;
}
} // namespace chaindrive::drive
