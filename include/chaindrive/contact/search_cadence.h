// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/utilities/archive.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
/// Speed [m/s] with which gaps of elastic bodies may close beyond what their velocities tell, until
/// they are looked at again: of vibration, 100 MPa in a wave are 2.5 m/s, and of impacts, which may
/// be as fast as bodies fly. With half of this, contacts are missed where wide clearances close at
/// full speed.
inline double unforeseen_speed(const World &world)
{
  double square = 25.;
  for (const Frame &frame : world.frames)
    square = std::max(square, frame.velocity.norm_square());
  return std::sqrt(square);
}

/// How long [s] a @p gap [m] cannot close: it closes at @p speed [m/s] now, is taken to close at
/// less than twice that until it is looked at again, plus @p unforeseen [m/s] for what bodies do
/// meanwhile (vibration, and impacts that turn them round).
inline double holding_time(const double gap, const double speed, const double unforeseen)
{
  return gap / (2. * speed + unforeseen);
}

/// When what has been searched must be searched again: a stock that runs out. It is a time [s], see
/// holding_time(), or a distance [m] by which surfaces may come nearer.
class SearchCadence
{
public:
  /// Whether a search must come before forces are evaluated that take @p use of the stock. At the
  /// first time it must.
  bool is_due(const double use) const { return !(use < stock_); }

  /// A search, after which nothing can touch before @p stock has been used up.
  void restart(const double stock)
  {
    stock_      = stock;
    left_alone_ = false;
  }

  /// Forces are evaluated without a search.
  void use(const double part)
  {
    stock_ -= part;
    left_alone_ = true;
  }

  double stock() const { return stock_; }

  /// More, or less, is left than has been counted.
  void extend(const double stock) { stock_ = stock; }

  /// Whether forces have been evaluated without a search since the last one: a penetration that is
  /// found then, where there was a gap, has been missed.
  bool left_alone() const { return left_alone_; }

  /// Makes this hold for what both held for.
  void join(const SearchCadence &other)
  {
    stock_      = std::min(stock_, other.stock_);
    left_alone_ = left_alone_ || other.left_alone_;
  }

  void serialize(const Archive &archive)
  {
    archive("stock", stock_);
    archive("left alone", left_alone_);
  }

private:
  double stock_      = -1.;
  bool   left_alone_ = false;
};

/// A clock for the cadence of very many points, s.
struct SearchClock
{
  double now = 0., before = 0.; ///< at this evaluation of forces and at the last one

  void advance(const double dt)
  {
    before = now;
    now += dt;
  }

  void serialize(const Archive &archive)
  {
    archive("now", now);
    archive("before", before);
  }
};

/// SearchCadence of one of very many points, which has nothing to do while it is left alone.
struct PointCadence
{
  double due     = -1.; ///< when it must be visited again, s; negative: for the first time
  double visited = 0.;  ///< when, s

  bool is_due(const SearchClock &clock) const { return !(due > clock.now); }

  bool left_alone(const SearchClock &clock) const { return due >= 0. && visited < clock.before; }

  /// A visit, after which it cannot touch for the time @p holds [s].
  void restart(const SearchClock &clock, const double holds)
  {
    visited = clock.now;
    due     = clock.now + holds;
  }
};
} // namespace chaindrive::contact
