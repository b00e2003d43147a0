// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/signal_statistics.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace chaindrive
{
namespace
{
constexpr double turn = 2. * dealii::numbers::PI;
} // namespace

WholeRevolutions::Waves WholeRevolutions::waves(const double turned) const
{
  Waves result;
  result.cosine[0] = std::cos(turned);
  result.sine[0]   = std::sin(turned);
  for (unsigned int n = 1; n < n_orders; ++n) // angle sums
    {
      result.cosine[n] =
          result.cosine[n - 1] * result.cosine[0] - result.sine[n - 1] * result.sine[0];
      result.sine[n] =
          result.sine[n - 1] * result.cosine[0] + result.cosine[n - 1] * result.sine[0];
    }
  return result;
}

const std::vector<WholeRevolutions::Piece> &
WholeRevolutions::next(const double time, const double duration, const double phase)
{
  // a turn that ends with the window, but for round-off, is within it
  constexpr double tolerance = 1e-6;

  pieces_.clear();
  const double before = std::exchange(state_.phase, phase);
  const double growth = phase - before;
  if (state_.closed || !(duration > 0.) || !(growth > 0.) || time + duration <= start_)
    return pieces_;
  double from = 0.;
  if (!state_.begun)
    {
      from         = std::clamp((start_ - time) / duration, 0., 1.);
      state_.zero  = before + from * growth;
      state_.begun = true;
    }
  const double last = (end_ - time) / duration; // the window's end in this step
  while (from < 1. && !state_.closed)
    {
      const double turned = std::max(before + from * growth - state_.zero, state_.turns * turn);
      const double rest   = (state_.turns + 1) * turn - turned;
      const bool   closes = rest <= (1. - from) * growth + tolerance * growth;
      const double to     = closes ? std::min(from + rest / growth, 1.) : 1.;
      if (to > last + tolerance)
        {
          state_.closed = true;
          break;
        }
      const double phase_grown = (to - from) * growth;
      // where the next step begins, which has the same waves
      const double reached = to < 1. ? turned + phase_grown : phase - state_.zero;
      const Waves  first   = turned == reached_ ? waves_there_ : waves(turned);
      waves_there_         = waves(reached);
      reached_             = reached;
      pieces_.push_back({from, to, phase_grown, first, waves_there_, closes});
      state_.turns += closes ? 1 : 0;
      from = to;
    }
  return pieces_;
}

void SignalStatistics::add(const double                                time,
                           const double                                duration,
                           const double                                value,
                           const std::vector<WholeRevolutions::Piece> &pieces)
{
  mean_.add(time, duration, value);
  if (const double weight = mean_.inside(time, duration); weight > 0.)
    { // B. P. Welford, Technometrics 4 (1962) 419, with weights
      const double difference = value - running_mean_;
      running_mean_ += difference * weight / mean_.duration();
      squares_ += weight * difference * (value - running_mean_);
      least_   = std::fmin(least_, value); // ignores NaN
      largest_ = std::fmax(largest_, value);
    }
  for (const WholeRevolutions::Piece &piece : pieces)
    {
      const double first = before_ + piece.from * (value - before_);
      const double last  = before_ + piece.to * (value - before_);
      for (unsigned int n = 0; n < WholeRevolutions::n_orders; ++n)
        {
          open_cosine_[n] +=
              0.5 * piece.phase * (first * piece.first.cosine[n] + last * piece.last.cosine[n]);
          open_sine_[n] +=
              0.5 * piece.phase * (first * piece.first.sine[n] + last * piece.last.sine[n]);
        }
      if (!piece.closes)
        continue;
      for (unsigned int n = 0; n < WholeRevolutions::n_orders; ++n)
        {
          cosine_[n] += std::exchange(open_cosine_[n], 0.);
          sine_[n] += std::exchange(open_sine_[n], 0.);
        }
    }
  before_ = value;
}

bool SignalStatistics::go_on_from(const SignalStatistics &earlier, const double time)
{
  WindowMean mean = mean_;
  const bool same = mean.go_on_from(earlier.mean_, time);
  *this           = earlier;
  mean_           = mean;
  return same;
}

double SignalStatistics::deviation() const
{
  return mean_.duration() > 0. ? std::sqrt(std::max(squares_, 0.) / mean_.duration()) :
                                 std::nan("");
}

SignalStatistics::Orders SignalStatistics::harmonics(const unsigned int turns) const
{
  Orders amplitudes;
  for (unsigned int n = 0; n < WholeRevolutions::n_orders; ++n)
    amplitudes[n] =
        turns > 0 ? 2. * std::hypot(cosine_[n], sine_[n]) / (turns * turn) : std::nan("");
  return amplitudes;
}
} // namespace chaindrive
