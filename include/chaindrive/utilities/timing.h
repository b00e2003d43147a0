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
/// A time stamp in arbitrary, constant units.
inline std::uint64_t time_stamp()
{
#if defined(__x86_64__)
  return __builtin_ia32_rdtsc();
#else
  return std::chrono::steady_clock::now().time_since_epoch().count();
#endif
}

/// While one exists, this process waits for other ranks or hands them numbers: what is done then
/// belongs to no phase of a PhaseTimer. They must not be nested. Costs half a microsecond.
class Waiting
{
public:
  Waiting();
  ~Waiting();
  Waiting(const Waiting &)            = delete;
  Waiting &operator=(const Waiting &) = delete;

  /// Since the start of this process: CPU time [s], and elapsed time in units of time_stamp().
  static double        cpu_seconds() { return cpu_seconds_; }
  static std::uint64_t ticks() { return ticks_; }

private:
  const std::uint64_t         begin_;
  const double                cpu_at_begin_;
  inline static std::uint64_t ticks_       = 0;
  inline static double        cpu_seconds_ = 0.;
};

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

  /// From now on rows() has one more, before the rest: Waiting since this was made.
  void count_waiting() { counts_waiting_ = true; }

  /// CPU time of every phase up to now, the rest last.
  std::vector<Row> rows() const;

  /// CPU time of this process that it did not wait, and that it did, since it was started [s].
  struct OfRank
  {
    double busy, waiting;
  };
  static OfRank of_this_rank()
  {
    return {total() - Waiting::cpu_seconds(), Waiting::cpu_seconds()};
  }

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
  /// Stands still while others are waited for.
  static std::uint64_t clock() { return time_stamp() - Waiting::ticks(); }

  std::vector<std::string>              names_;
  std::vector<std::uint64_t>            ticks_;
  Phase                                 running_ = rest;
  std::uint64_t                         start_, last_;
  double                                cpu_at_start_, waited_at_start_;
  bool                                  counts_waiting_ = false;
  std::vector<double>                   earlier_; ///< per row, if as many
  double                                earlier_elapsed_ = 0.;
  std::chrono::steady_clock::time_point made_            = std::chrono::steady_clock::now();
};
} // namespace chaindrive
