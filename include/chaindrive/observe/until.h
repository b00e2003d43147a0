// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/json.h>
#include <chaindrive/parameters/run.h>

#include <string>
#include <vector>

namespace chaindrive::observe
{
/// Output/Until: what a run is to find out, and how exactly; it ends when it knows.
class Until
{
public:
  /// @p wanted: mean values of the summary; @p pitches_per_period pitch times hold a period of the
  /// drive's slowest resonance. InputError for one that is not among those of @p start, the summary
  /// of the run before its first step.
  Until(const std::vector<parameters::Wanted> &wanted,
        const files::Json                     &start,
        unsigned int                           pitches_per_period);

  /// Whether anything is wanted.
  bool is_asked() const { return !wanted_.empty(); }

  /// Adds `until` to the @p summary of the run up to now: of each mean, `wanted`, its `uncertainty`
  /// over its magnitude, not a number as long as the window has less than eight periods of the
  /// slowest resonance, and whether that is `reached`. Nothing if nothing is asked.
  void summarize(files::Json &summary) const;

  /// Whether all of @p summary, to which summarize() has added, are reached.
  static bool is_reached(const files::Json &summary);

private:
  std::vector<parameters::Wanted> wanted_;
  unsigned int                    fewest_ = 0; ///< tooth periods or impacts in the window
};

/// What is to be said of `until` in the @p summary of a run that has come to its end at @p time
/// [s]: what it has found out, or what it would take. Empty if nothing was asked.
std::string until_sentence(const files::Json &summary, double time);
} // namespace chaindrive::observe
