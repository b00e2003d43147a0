// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/settling.h>

#include <cmath>
#include <string>

namespace chaindrive::observe
{
namespace
{
constexpr double accepted   = 0.05;  // drift over n_periods, of the scale
constexpr double negligible = 0.005; // likewise
constexpr double student    = 2.776; // 97.5 % point for n_periods - 2 = 4 degrees of freedom

/// Whether the drift of these means is accepted.
bool settled_of(const std::vector<double> &y, const double scale)
{
  const double n      = static_cast<double>(y.size());
  const double middle = 0.5 * (n - 1.);
  double       mean = 0., square = 0., product = 0., residuals = 0.;
  for (const double value : y)
    mean += value / n;
  for (unsigned int i = 0; i < y.size(); ++i)
    {
      square += (i - middle) * (i - middle);
      product += (i - middle) * (y[i] - mean);
    }
  const double slope = product / square;
  for (unsigned int i = 0; i < y.size(); ++i)
    residuals += std::pow(y[i] - mean - slope * (i - middle), 2);
  const double error = std::sqrt(residuals / ((n - 2.) * square));
  const double drift = (n - 1.) * std::abs(slope);
  return drift <= accepted * scale &&
         (std::abs(slope) <= student * error || drift <= negligible * scale);
}
} // namespace

void Settling::add(const std::vector<double> &means, const std::vector<double> &scales)
{
  means_.push_back(means);
  scales_ = scales;
  if (means_.size() > n_periods)
    means_.pop_front();
}

bool Settling::settled() const
{
  if (means_.size() < n_periods)
    return false;
  for (unsigned int s = 0; s < scales_.size(); ++s)
    {
      std::vector<double> signal;
      for (const std::vector<double> &means : means_)
        signal.push_back(means[s]);
      if (!settled_of(signal, scales_[s]))
        return false;
    }
  return true;
}

void Settling::serialize(const Archive &archive)
{
  unsigned int n = static_cast<unsigned int>(means_.size());
  archive("periods", n);
  means_.resize(n);
  for (unsigned int i = 0; i < n; ++i)
    archive("period " + std::to_string(i), means_[i]);
  archive("scales", scales_);
}
} // namespace chaindrive::observe
