// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/observe/settling.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/statistics.h>

#include <vector>

namespace chaindrive::observe
{
class Observation;

/// Watches from period to period whether the drive has settled (Settling), by the tension of the
/// tight span less that of the slack one, the speeds of all loads and the driver torque. A period
/// is as many whole pitch times as hold one of the drive's slowest resonance, which would look like
/// a drift over fewer. Their scales are the sum of both tensions; a fifth of the speed, whose mean
/// the numbers of teeth fix; and the torque of that sum on the driver's pitch circle.
class Drift
{
public:
  /// Of a drive whose driver turns, and whose slowest resonance has a period of at most
  /// @p pitches_per_period pitch times.
  Drift(const scene::Scene &scene, unsigned int pitches_per_period);

  /// The first period begins at @p time [s].
  void begin(double time);

  /// Takes the signals of a step into the means of the present period. First rank only.
  void add(const Observation &now);

  /// Closes the present period, which ends in this step or before, and begins the next.
  void next_period(const Observation &now);

  /// Whether the drive has settled; known to the first rank only.
  bool settled() const { return settling_.settled(); }

  double       pitch_time() const { return pitch_time_; }     ///< s
  double       period_start() const { return from_; }         ///< of the present period, s
  double       period_end() const { return from_ + period_; } ///< s
  unsigned int n_periods() const { return n_; }               ///< that have been closed

  void serialize(const Archive &archive);

private:
  double                  from_       = 0.; ///< begin of the present period, s
  double                  pitch_time_ = 0.; ///< s
  double                  period_     = 0.; ///< s
  double                  radius_     = 0.; ///< of the driver's pitch circle, m
  unsigned int            n_          = 0;
  unsigned int            n_loads_    = 0; ///< sprockets that have one
  std::vector<WindowMean> means_;          ///< over the present period
  Settling                settling_;
};
} // namespace chaindrive::observe
