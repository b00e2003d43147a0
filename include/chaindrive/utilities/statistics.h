// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace chaindrive
{
/// Time-weighted mean of a quantity over the window [start, end].
class WindowMean
{
public:
  WindowMean(const double start, const double end) : start_(start), end_(end) {}

  /// How much of the interval from @p time to @p time + @p duration [s] lies in the window, s; not
  /// positive: nothing.
  double inside(const double time, const double duration) const
  {
    return std::min(time + duration, end_) - std::max(time, start_);
  }

  /// The quantity is @p value from @p time to @p time + @p duration; only the part of this interval
  /// that lies in the window counts.
  void add(const double time, const double duration, const double value)
  {
    const double part = inside(time, duration);
    if (part > 0.)
      {
        weight_ += part;
        sum_ += part * value;
      }
  }

  /// From now on the window is another one.
  void move_to(const double start, const double end)
  {
    start_ = start;
    end_   = end;
  }

  /// Goes on from the mean of an @p earlier part of the run, which ended at @p time. Returns
  /// whether that is possible: up to then both windows must be the same.
  bool go_on_from(const WindowMean &earlier, const double time)
  {
    weight_ = earlier.weight_;
    sum_    = earlier.sum_;
    return std::min(start_, time) == std::min(earlier.start_, time) &&
           std::min(end_, time) == std::min(earlier.end_, time);
  }

  /// Not a number when nothing fell into the window.
  double mean() const { return weight_ > 0. ? sum_ / weight_ : std::nan(""); }

  /// The part of the window seen so far [s].
  double duration() const { return weight_; }

private:
  double start_, end_;
  double weight_ = 0., sum_ = 0.;
};
} // namespace chaindrive
