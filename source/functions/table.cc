// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/functions/function.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace chaindrive::functions
{
namespace
{
/// The slopes at the points; at the first and the last one those of the chords.
std::vector<double> slopes(const std::vector<double> &x, const std::vector<double> &y)
{
  const std::size_t   n = x.size();
  std::vector<double> slope(n, 0.);
  const auto chord = [&](const std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  if (n > 1)
    {
      slope.front() = chord(0);
      slope.back()  = chord(n - 2);
    }
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (chord(i - 1) * chord(i) > 0.)
      {
        const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
        const double of_left = 2. * right + left, of_right = right + 2. * left;
        slope[i] = (of_left + of_right) / (of_left / chord(i - 1) + of_right / chord(i));
      }
  return slope;
}
} // namespace

Table::Table(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y))
{
  if (x_.empty() || x_.size() != y_.size())
    throw std::invalid_argument("a table needs points");
  for (std::size_t i = 1; i < x_.size(); ++i)
    if (!(x_[i - 1] < x_[i]))
      throw std::invalid_argument("the places of a table must rise");
  slope_ = slopes(x_, y_);
  before_.assign(1, 0.);
  for (std::size_t i = 1; i < x_.size(); ++i)
    {
      const double h = x_[i] - x_[i - 1];
      before_.push_back(before_.back() +
                        h * (0.5 * (y_[i - 1] + y_[i]) + h * (slope_[i - 1] - slope_[i]) / 12.));
    }
}

Table::Place Table::place(const double x) const
{
  const auto         next  = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const unsigned int piece = static_cast<unsigned int>(next - x_.begin()) - 1;
  const double       h     = x_[piece + 1] - x_[piece];
  return {piece, h, (x - x_[piece]) / h};
}

double Table::value(const double x) const
{
  if (x <= x_.front())
    return y_.front();
  if (x >= x_.back())
    return y_.back();
  const auto [i, h, s] = place(x);
  const double rise    = y_[i + 1] - y_[i];
  const double a = h * slope_[i] - rise, b = rise - h * slope_[i + 1];
  return y_[i] + s * (rise + (1. - s) * (a * (1. - s) + b * s));
}

double Table::derivative(const double x) const
{
  if (x < x_.front() || x >= x_.back())
    return 0.;
  const auto [i, h, s] = place(x);
  const double chord   = (y_[i + 1] - y_[i]) / h;
  return (1. - s) * (1. - 3. * s) * slope_[i] + 6. * s * (1. - s) * chord +
         s * (3. * s - 2.) * slope_[i + 1];
}

double Table::primitive(const double x) const
{
  if (x <= x_.front())
    return y_.front() * (x - x_.front());
  if (x >= x_.back())
    return before_.back() + y_.back() * (x - x_.back());
  const auto [i, h, s] = place(x);
  const double rise    = y_[i + 1] - y_[i];
  const double a = h * slope_[i] - rise, b = rise - h * slope_[i + 1];
  // of the polynomial in value(), term by term
  const double cubic =
      s * s * (0.5 - s * (2. / 3.) + 0.25 * s * s) * a + s * s * s * (1. / 3. - 0.25 * s) * b;
  return before_[i] + h * (s * (y_[i] + 0.5 * s * rise) + cubic);
}

double Table::integral(const double from, const double to) const
{
  return primitive(to) - primitive(from);
}

std::vector<double> Table::breakpoints(const double from, const double to) const
{
  std::vector<double> found;
  for (const double x : x_)
    if (from < x && x < to)
      found.push_back(x);
  return found;
}

double Table::largest(const double from, const double to) const
{
  double most = std::max(std::abs(value(from)), std::abs(value(to)));
  for (std::size_t i = 0; i < x_.size(); ++i)
    if (from <= x_[i] && x_[i] <= to)
      most = std::max(most, std::abs(y_[i]));
  return most;
}

double Table::steepest(const double from, const double to) const
{
  double     most = 0.;
  const auto look = [&](const double x) {
    if (from <= x && x <= to)
      most = std::max(most, std::abs(derivative(x)));
  };
  look(from);
  look(to);
  for (std::size_t i = 0; i + 1 < x_.size(); ++i)
    {
      if (from <= x_[i] && x_[i] < to)
        most = std::max(most, std::abs(slope_[i]));
      if (from < x_[i + 1] && x_[i + 1] <= to)
        most = std::max(most, std::abs(slope_[i + 1]));
      // where the slope, a parabola, has its vertex
      const double chord = (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
      const double bend  = slope_[i] + slope_[i + 1] - 2. * chord;
      const double s =
          bend != 0. ? (2. * slope_[i] + slope_[i + 1] - 3. * chord) / (3. * bend) : 0.;
      if (s > 0. && s < 1.)
        look(x_[i] + s * (x_[i + 1] - x_[i]));
    }
  return most;
}
} // namespace chaindrive::functions
