// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/observer.h>
#include <chaindrive/files/log.h>

#include <chrono>
#include <string>

namespace chaindrive::observe
{
/// How far a run has come and how long it will still take: one line that is rewritten on a
/// terminal, plain lines every 5 % in a log.
class Progress : public dynamics::Observer
{
public:
  /// From @p start to @p end [s of simulated time]. @p terminal: the console can rewrite a line.
  Progress(files::Log &log, double start, double end, bool terminal = console_is_terminal());

  /// Takes the rewritten line away.
  ~Progress() override;

  /// Says it on the first rank.
  void        observe(const dynamics::System &system,
                      unsigned long           step,
                      double                  dt,
                      dynamics::Services     &services) override;
  bool        asks_for_bodies() const override { return true; }
  std::string name() const override { return "progress"; }

  /// A run that comes out of a checkpoint begins there: what is before has been computed earlier.
  void serialize(const Archive &archive, const dynamics::System &system) override;

  /// To be called as often as convenient, every sample for example: mostly there is nothing to say.
  void update(double time);

  /// Whether standard output is a terminal of the user's own. What mpirun gives its processes looks
  /// like one, wherever mpirun's own output goes.
  static bool console_is_terminal();

private:
  using Clock = std::chrono::steady_clock;

  files::Log       &log_;
  const double      start_, end_;
  double            first_; ///< s, where this part of the run began
  const bool        terminal_;
  Clock::time_point began_, shown_;
  int               reported_ = 0; ///< steps of 5 % in the log
};

/// A length of time as people say it: "8 s", "3 min 20 s", "2 h 05 min".
std::string duration_text(double seconds);
} // namespace chaindrive::observe
