// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/archive.h>

#include <algorithm>

namespace chaindrive::observe
{
/// What happens at the first step at or after multiples of an interval.
class Schedule
{
public:
  /// From @p start on, every @p interval [s]; 0: never.
  Schedule(const double start, const double interval) : start_(start), interval_(interval) {}

  bool due(const double time)
  {
    if (interval_ == 0. || time < start_ + next_ * interval_ * (1. - 1e-12))
      return false;
    next_ = after(time);
    return true;
  }

  /// The run that comes out of a checkpoint at @p time may have another interval.
  void serialize(const Archive &archive, const double time)
  {
    double interval = interval_;
    archive("interval", interval);
    archive("next", next_);
    if (interval != interval_ && interval_ > 0.)
      next_ = after(time);
  }

private:
  unsigned long after(const double time) const
  {
    // an interval that is too short to be counted is over at every step
    return static_cast<unsigned long>(std::min((time - start_) / interval_ + 1e-9, 1e15)) + 1;
  }

  double        start_, interval_;
  unsigned long next_ = 0;
};
} // namespace chaindrive::observe
