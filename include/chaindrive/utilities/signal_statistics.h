// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/statistics.h>

#include <array>
#include <vector>

namespace chaindrive
{
/// Cuts steps where a phase has gone a whole number of turns since the begin of a window, so that
/// Fourier integrals over whole revolutions are free of leakage whatever the step.
class WholeRevolutions
{
public:
  static constexpr unsigned int n_orders = 4;
  using Orders                           = std::array<double, n_orders>;

  /// Cosine and sine of 1, 2, ... times the phase.
  struct Waves
  {
    Orders cosine, sine;
  };

  /// A part of a step within one turn.
  struct Piece
  {
    double from, to; ///< where in the step it begins and ends, 0 to 1
    double phase;    ///< by which the phase grows in it, rad
    Waves  first, last;
    bool   closes; ///< a turn ends with it
  };

  /// Of a window from @p start to @p end [s].
  WholeRevolutions(const double start, const double end) : start_(start), end_(end) {}

  /// From now on the window is another one.
  void move_to(const double start, const double end)
  {
    start_ = start;
    end_   = end;
  }

  /// The phase has become @p phase [rad] at the end of a step from @p time on of @p duration [s],
  /// in which it grew evenly. Returns the pieces of the step that lie in the window, none while the
  /// phase stands or goes back; they are valid until the next call.
  const std::vector<Piece> &next(double time, double duration, double phase);

  /// Whole revolutions that have ended in the window.
  unsigned int n_revolutions() const { return state_.turns; }

  /// All that it remembers from step to step, to be copied.
  struct State
  {
    double       phase = 0., zero = 0.; ///< at the last step, and at the begin of the window, rad
    unsigned int turns  = 0;
    bool         begun  = false;
    bool         closed = false; ///< the window has ended
  };
  State &state() { return state_; }

private:
  Waves waves(double turned) const;

  double             start_, end_; ///< s
  State              state_;
  std::vector<Piece> pieces_;
  double             reached_ = -1.; ///< phase since the begin of the window at the last end of a
                                     ///< piece, rad; below zero: none
  Waves waves_there_{};
};

/// Time-weighted mean, standard deviation, least and largest value of a signal over a window, and
/// the amplitudes of the first harmonics of a phase over its whole revolutions:
///
///   a_n = |2/Phi int x exp(i n phi) dphi|,   Phi = 2 pi times the number of whole revolutions,
///
/// by the trapezoidal rule over the steps. For mean and deviation the value at the end of a step
/// stands for the whole step.
class SignalStatistics
{
public:
  using Orders = WholeRevolutions::Orders;

  /// Of a window from @p start to @p end [s].
  SignalStatistics(const double start, const double end) : mean_(start, end) {}

  /// The signal is @p value at the end of a step from @p time on of @p duration [s], whose @p
  /// pieces are in the window.
  void add(double                                      time,
           double                                      duration,
           double                                      value,
           const std::vector<WholeRevolutions::Piece> &pieces);

  /// See WindowMean.
  void move_to(const double start, const double end) { mean_.move_to(start, end); }
  bool go_on_from(const SignalStatistics &earlier, double time);

  // Not a number when nothing fell into the window.
  double mean() const { return mean_.mean(); }
  double deviation() const; ///< of the signal from its mean in the window, root of the mean square
  double least() const { return least_; }
  double largest() const { return largest_; }

  /// Amplitudes over @p turns whole revolutions; not a number when there are none.
  Orders harmonics(unsigned int turns) const;

private:
  WindowMean mean_;
  double     running_mean_ = 0., squares_ = 0.; ///< Welford's sums
  double     least_ = std::nan(""), largest_ = std::nan("");
  double     before_ = 0.;                 ///< value at the end of the last step
  Orders     open_cosine_{}, open_sine_{}; ///< integrals over the turn that has not ended
  Orders     cosine_{}, sine_{};           ///< over those that have
};
} // namespace chaindrive
