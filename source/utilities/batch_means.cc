// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/batch_means.h>

#include <deal.II/base/numbers.h>

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace chaindrive
{
double uncertainty_of_mean(const std::vector<double> &values, const std::size_t least)
{
  constexpr std::size_t fewest = 4, most = 20;

  const std::size_t length = std::max(least, (values.size() + most - 1) / most);
  const std::size_t n      = length == 0 ? 0 : values.size() / length;
  if (n < fewest)
    return std::nan("");
  std::vector<double> batches;
  for (auto end = values.begin() + static_cast<std::ptrdiff_t>(values.size() - n * length);
       end != values.end();)
    {
      const auto begin = std::exchange(end, end + static_cast<std::ptrdiff_t>(length));
      batches.push_back(std::accumulate(begin, end, 0.) / static_cast<double>(length));
    }
  const double k       = static_cast<double>(n);
  const double mean    = std::accumulate(batches.begin(), batches.end(), 0.) / k;
  double       squares = 0., products = 0.;
  for (std::size_t j = 0; j < n; ++j)
    {
      squares += (batches[j] - mean) * (batches[j] - mean);
      if (j > 0)
        products += (batches[j - 1] - mean) * (batches[j] - mean);
    }
  const double found       = squares > 0. ? products / squares : 0.;
  const double correlation = std::clamp(found + (1. + 3. * found) / k, 0., 0.9);
  const double student     = boost::math::quantile(boost::math::students_t(k - 1.), 0.975);
  return student * std::sqrt(squares / (k - 1.) / k * (1. + correlation) / (1. - correlation));
}

void RevolutionMeans::add(const double value, const std::vector<WholeRevolutions::Piece> &pieces)
{
  for (const WholeRevolutions::Piece &piece : pieces)
    {
      const double first = before_ + piece.from * (value - before_);
      const double last  = before_ + piece.to * (value - before_);
      open_ += 0.5 * piece.phase * (first + last);
      if (piece.closes)
        means_.push_back(std::exchange(open_, 0.) / (2. * dealii::numbers::PI));
    }
  before_ = value;
}
} // namespace chaindrive
