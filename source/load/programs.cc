// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/load/programs.h>
#include <chaindrive/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::load
{
using dealii::numbers::PI;

SpeedProgram::SpeedProgram(const scene::Scene &scene)
    : speed_(scene.sense * scene.loads.driver_speed)
    , start_(scene.start_time)
    , ramp_time_(scene.at_speed ? 0. : scene.loads.ramp_time)
    , cosine_(scene.loads.speed_ramp == parameters::SpeedRamp::cosine)
{
}

double SpeedProgram::speed(const double time) const
{
  const double t = time - start_;
  if (t >= ramp_time_)
    return speed_;
  const double s = t / ramp_time_;
  return speed_ * (cosine_ ? 0.5 * (1. - std::cos(PI * s)) : s);
}

double SpeedProgram::angle(const double time) const
{
  const double t = time - start_;
  if (t >= ramp_time_) // both ramps have covered half of what full speed would have
    return speed_ * (t - 0.5 * ramp_time_);
  const double s = t / ramp_time_;
  return speed_ * ramp_time_ * (cosine_ ? 0.5 * s - std::sin(PI * s) / (2. * PI) : 0.5 * s * s);
}

TorqueCurve::TorqueCurve(const scene::Scene &scene)
    : full_(scene.loads.resisting_torque)
    , ramp_(scene.loads.torque_ramp_angle)
    , offset_(scene.torque_angle_offset)
    , step_(scene.start_time +
            scene.loads.torque_step_time.value_or(std::numeric_limits<double>::infinity()))
    , after_(scene.loads.torque_after_step)
    , sense_(scene.sense)
{
}

double TorqueCurve::torque(const double angle, const double time) const
{
  if (time >= step_)
    return -sense_ * after_;
  const double turned = sense_ * angle + offset_;
  const double share  = ramp_ > 0. ? std::clamp(turned / ramp_, 0., 1.) : (turned >= 0. ? 1. : 0.);
  return -sense_ * full_ * share;
}
} // namespace chaindrive::load
