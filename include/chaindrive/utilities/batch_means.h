// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/signal_statistics.h>

#include <cstddef>
#include <vector>

namespace chaindrive
{
/// Half the width of the 95 % confidence interval of the mean of a stationary sequence of which
/// @p values is a part, in their unit; not a number when there are too few of them. By batch means
/// [R. W. Conway, Management Science 10 (1963) 47]: successive values are averaged in K batches, 4
/// to 20, of equal length, at least @p least values each; values at the begin that fill no batch
/// are left out. With the mean m of the batch means y_j, their variance s^2 and the correlation r
/// of successive ones,
///
///   half width = t(K - 1) sqrt(s^2 / K (1 + r) / (1 - r)),   0 <= r <= 0.9,
///
/// where t is the 0.975 quantile of Student's distribution, and the last factor, that of a first
/// order autoregressive process, stands for batches that are too short to be independent; the bias
/// of r, -(1 + 3 r) / K, is taken off [M. G. Kendall, Biometrika 41 (1954) 403].
double uncertainty_of_mean(const std::vector<double> &values, std::size_t least = 1);

/// The means of a signal over each whole revolution of a phase, by the trapezoidal rule over the
/// steps: without what recurs in every revolution.
class RevolutionMeans
{
public:
  /// The signal is @p value at the end of a step whose @p pieces are in the window.
  void add(double value, const std::vector<WholeRevolutions::Piece> &pieces);

  const std::vector<double> &values() const { return means_; }

  template <typename BoostArchive>
  void serialize(BoostArchive &archive, unsigned int)
  {
    archive &before_ &open_ &means_;
  }

private:
  double              before_ = 0.; ///< value at the end of the last step
  double              open_   = 0.; ///< integral over the revolution that has not ended
  std::vector<double> means_;
};
} // namespace chaindrive
