// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/json.h>
#include <chaindrive/observe/settling.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/statistics.h>

#include <vector>

namespace chaindrive::observe
{
class Observation;

/// The window over which the summary averages: from a time that is given, or for
/// Output/Window start in ms = settled, from the end of the pitch time after which the drive has
/// settled (Settling), over a number of whole pitch times. The drive is then looked at from the
/// instant on at which the driver has its full speed and the load torque has jumped, if it does.
class Window
{
public:
  /// Of the tension of the tight span less that of the slack one, the driven speed and the driver
  /// torque, and their scales: the sum of both tensions; a fifth of the speed, whose mean the
  /// numbers of teeth fix; and the torque of that sum on the driver's pitch circle.
  Window(const scene::Scene &scene, const Parameters &parameters);

  /// Looks at a step. The first rank decides, all ranks know it from the same step on. Collective.
  void look(const Observation &now);

  double start() const { return start_; } ///< s; infinite as long as the drive has not settled
  double end() const { return end_; }     ///< s; infinite: the end of the run

  /// Whether it begins when the drive has settled, and whether it has.
  bool waits() const { return waits_; }
  bool settled() const { return waits_ && open_; }

  /// Whether the run may end at @p time [s] since a window that waits is full.
  bool is_full(const double time) const { return settled() && time >= end_; }

  /// `window` of the summary of a run that has come to @p time [s].
  files::Json summary(double time) const;

  /// InputError when the run that goes on has a window of the other kind.
  void serialize(const Archive &archive);

private:
  /// Takes the signals of a step into the means of the present pitch time.
  void add(const Observation &now);

  /// Closes the present pitch time and begins the next.
  void next_period(const Observation &now);

  bool                    waits_, open_;
  double                  start_, end_; ///< s
  double                  run_end_;     ///< s
  double                  from_   = 0.; ///< begin of the present pitch time, s
  double                  period_ = 0.; ///< pitch time, s
  double                  length_ = 0.; ///< s
  double                  radius_ = 0.; ///< of the driver's pitch circle, m
  std::vector<WindowMean> means_;       ///< over the present pitch time
  Settling                settling_;
};
} // namespace chaindrive::observe
