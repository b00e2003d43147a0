// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace chaindrive
{
namespace scene
{
struct Scene;
}
} // namespace chaindrive

namespace chaindrive::load
{
/// Rotation of the prescribed hub: from rest to the full speed over the ramp, then constant; or at
/// full speed from the start. Signed: positive is counter-clockwise. Exact at any time.
class SpeedProgram
{
public:
  explicit SpeedProgram(const scene::Scene &scene);

  double angle(double time) const; ///< rad since the start
  double speed(double time) const; ///< rad/s

private:
  double speed_;     ///< final, signed, rad/s
  double start_;     ///< time at which the ramp begins, s
  double ramp_time_; ///< s; 0: at full speed from the start
  bool   cosine_;
};

/// Torque of the load on the driven hub over its angle: it grows linearly with the angle turned in
/// the sense of the drive, then stays constant, always against that sense. From the time of the
/// step on it is another constant.
class TorqueCurve
{
public:
  explicit TorqueCurve(const scene::Scene &scene);

  /// N m on the hub, at @p angle [rad] since the start and @p time [s].
  double torque(double angle, double time) const;

private:
  double full_;   ///< N m
  double ramp_;   ///< rad
  double offset_; ///< rad by which the ramp is ahead at the start
  double step_;   ///< time of the step, s
  double after_;  ///< resisting torque after it, N m
  int    sense_;
};
} // namespace chaindrive::load
