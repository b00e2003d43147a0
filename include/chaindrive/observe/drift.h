// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/observe/settling.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/statistics.h>

#include <vector>

namespace chaindrive::observe
{
class Observation;

/// Watches from pitch time to pitch time whether the drive has settled (Settling), by the tension
/// of the tight span less that of the slack one, the driven speed and the driver torque. Their
/// scales are the sum of both tensions; a fifth of the speed, whose mean the numbers of teeth fix;
/// and the torque of that sum on the driver's pitch circle.
class Drift
{
public:
  /// Of a drive whose driver turns.
  Drift(const scene::Scene &scene, const Parameters &parameters);

  /// The first pitch time begins at @p time [s].
  void begin(double time);

  /// Takes the signals of a step into the means of the present pitch time. First rank only.
  void add(const Observation &now);

  /// Closes the present pitch time, which ends in this step or before, and begins the next.
  void next_period(const Observation &now);

  /// Whether the drive has settled; known to the first rank only.
  bool settled() const { return settling_.settled(); }

  double       pitch_time() const { return period_; }         ///< s
  double       period_start() const { return from_; }         ///< of the present pitch time, s
  double       period_end() const { return from_ + period_; } ///< s
  unsigned int n_periods() const { return n_; }               ///< that have been closed

  void serialize(const Archive &archive);

private:
  double                  from_   = 0.; ///< begin of the present pitch time, s
  double                  period_ = 0.; ///< pitch time, s
  double                  radius_ = 0.; ///< of the driver's pitch circle, m
  unsigned int            n_      = 0;
  std::vector<WindowMean> means_; ///< over the present pitch time
  Settling                settling_;
};
} // namespace chaindrive::observe
