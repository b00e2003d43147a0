// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive
{
/// Shares the CPU time of this process out among named phases. One phase runs at any time, so that
/// the phases add up to the total; changing it reads the processor's clock once (10 to 25 ns).
///
/// Phases are measured in elapsed time and scaled by the process's own CPU time, so that a busy
/// machine does not inflate them. No communication: each rank times itself.
class PhaseTimer
{
public:
  using Phase = unsigned int;

  /// What was not given to any phase, with all that happened before the timer was made.
  static constexpr Phase rest = 0;

  struct Row
  {
    std::string name;
    double      cpu_seconds;
    double      percentage; ///< of the total
  };

  PhaseTimer();

  /// The phase called @p name, made at the first call: phases are listed in that order. A phase
  /// that nobody adds has no row.
  Phase add(const std::string &name);

  /// The running phase ends and @p phase begins; returns the phase that ended.
  Phase enter(const Phase phase)
  {
    const std::uint64_t now = clock();
    ticks_[running_] += now - last_;
    last_ = now;
    return std::exchange(running_, phase);
  }

  /// A phase that lasts for a block; the phase it interrupts goes on afterwards.
  class Scope
  {
  public:
    Scope(PhaseTimer &timer, const Phase phase) : timer_(timer), outer_(timer.enter(phase)) {}
    ~Scope() { timer_.enter(outer_); }
    Scope(const Scope &)            = delete;
    Scope &operator=(const Scope &) = delete;

  private:
    PhaseTimer &timer_;
    const Phase outer_;
  };

  /// CPU time of every phase up to now, the rest last.
  std::vector<Row> rows() const;

  /// Time since this was made, and of what it goes on from [s].
  double elapsed() const
  {
    return earlier_elapsed_ +
           std::chrono::duration<double>(std::chrono::steady_clock::now() - made_).count();
  }

  /// Counts an earlier part of the run in: the CPU seconds of its rows(), and its time.
  void go_on_from(std::vector<double> cpu_seconds, const double elapsed)
  {
    earlier_         = std::move(cpu_seconds);
    earlier_elapsed_ = elapsed;
  }

  /// CPU time of this process since it was started, its initialisation included [s].
  static double total();

  /// A table of all phases with their CPU time and percentage, and the total.
  void        print(std::ostream &out) const { print(out, rows()); }
  static void print(std::ostream &out, const std::vector<Row> &table);

private:
  /// Time stamp in arbitrary, constant units.
  static std::uint64_t clock()
  {
#if defined(__x86_64__)
    return __builtin_ia32_rdtsc();
#else
    return std::chrono::steady_clock::now().time_since_epoch().count();
#endif
  }

  std::vector<std::string>              names_;
  std::vector<std::uint64_t>            ticks_;
  Phase                                 running_ = rest;
  std::uint64_t                         start_, last_;
  double                                cpu_at_start_;
  std::vector<double>                   earlier_; ///< per row, if as many
  double                                earlier_elapsed_ = 0.;
  std::chrono::steady_clock::time_point made_            = std::chrono::steady_clock::now();
};
} // namespace chaindrive
