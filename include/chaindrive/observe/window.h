// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/json.h>
#include <chaindrive/model/model.h>
#include <chaindrive/observe/drift.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/archive.h>

#include <optional>

namespace chaindrive::observe
{
class Observation;

/// The window over which the summary averages: from a time that is given, or for
/// Output/Window start in ms = settled, from the end of the period after which the drive has
/// settled (Drift), over a number of whole pitch times: as many as are asked for, and where a
/// period is longer than a pitch time, no fewer than the decision took; with Output/Until, to the
/// end of the run. The drive is then looked at from the instant on at which the driver has its full
/// speed and the load torque has jumped, if it does.
class Window
{
public:
  /// @p pitches_per_period: see Drift.
  Window(const scene::Scene &scene, const model::Model &model, unsigned int pitches_per_period);

  /// Looks at a step. The first rank decides, all ranks know it from the same step on. Collective.
  void update(const Observation &now);

  double start() const { return start_; } ///< s; infinite as long as the drive has not settled
  double end() const { return end_; }     ///< s; infinite: the end of the run

  /// Whether it begins when the drive has settled, and whether it has.
  bool waits() const { return waits_; }
  bool settled() const { return waits_ && open_; }

  /// Pitch times that hold a period of the drive's slowest resonance.
  unsigned int pitches_per_period() const { return pitches_per_period_; }

  /// Pitch times over which it is judged whether the drive has settled.
  unsigned int judged_pitches() const { return Settling::n_periods * pitches_per_period_; }

  /// When a window that waits can be full at the earliest, s; 0 for one that does not.
  double earliest_end() const { return earliest_end_; }

  /// Whether the run may end at @p time [s] since a window that waits is full.
  bool is_full(const double time) const { return settled() && time >= end_; }

  /// `window` of the summary of a run that has come to @p time [s].
  files::Json summary(double time) const;

  /// InputError when the run that goes on has a window of the other kind.
  void serialize(const Archive &archive);

private:
  /// Closes the present period and begins the next.
  void next_period(const Observation &now);

  bool                 waits_, open_;
  double               start_, end_; ///< s
  double               run_end_;     ///< s
  bool                 until_;       ///< the run ends when its means are known (Until)
  unsigned int         pitches_per_period_;
  double               length_       = 0.; ///< of a window that waits, s
  double               earliest_end_ = 0.; ///< s
  std::optional<Drift> drift_;             ///< of a drive that is waited for
};
} // namespace chaindrive::observe
