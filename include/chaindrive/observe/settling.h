// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/archive.h>

#include <deque>
#include <vector>

namespace chaindrive::observe
{
/// Tells from means over consecutive periods when signals have stopped drifting.
///
/// A straight line is laid through the means y_1 ... y_n of the last n = 6 periods by least
/// squares. With its slope b and the standard error s_b of b (NIST/SEMATECH e-Handbook of
/// Statistical Methods, 4.4.4 and 4.1.4.1)
///
///   b = sum (i - i_m) y_i / S,   s_b^2 = sum r_i^2 / ((n - 2) S),   S = sum (i - i_m)^2,
///
/// where r_i are the residuals, a signal of the scale Y has settled when its drift (n - 1) |b| is
///
/// - at most 5 % of Y, and
/// - not significant, |b| <= t s_b with the 97.5 % point t of Student's distribution of n - 2
///   degrees of freedom, or at most 0.5 % of Y, which needs no test.
///
/// A drift that is clearly there keeps the window shut however slow, down to 0.1 % per period; one
/// that is lost in the scatter of the means is let pass up to 1 % per period.
class Settling
{
public:
  static constexpr unsigned int n_periods = 6;

  /// Takes the @p means of one more period, and the @p scales by which the drift of each is judged.
  void add(const std::vector<double> &means, const std::vector<double> &scales);

  /// Whether all signals have settled; false before n_periods have been seen.
  bool settled() const;

  void serialize(const Archive &archive);

private:
  std::deque<std::vector<double>> means_; ///< of the last periods
  std::vector<double>             scales_;
};
} // namespace chaindrive::observe
