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
/// The most places that are told of a function that repeats itself.
constexpr double most_periods = 1e5;
} // namespace

double Resistance::value(const double x) const { return (linear_ + quadratic_ * std::abs(x)) * x; }

double Resistance::derivative(const double x) const
{
  return linear_ + 2. * quadratic_ * std::abs(x);
}

double Resistance::integral(const double from, const double to) const
{
  const auto primitive = [this](const double x) {
    return (0.5 * linear_ + quadratic_ / 3. * std::abs(x)) * x * x;
  };
  return primitive(to) - primitive(from);
}

std::vector<double> Resistance::breakpoints(const double from, const double to) const
{
  return quadratic_ != 0. && from < 0. && 0. < to ? std::vector<double>{0.} : std::vector<double>{};
}

double Resistance::largest(const double from, const double to) const
{
  const double x = std::max(std::abs(from), std::abs(to));
  return (std::abs(linear_) + std::abs(quadratic_) * x) * x;
}

double Resistance::steepest(const double from, const double to) const
{
  return std::abs(linear_) + 2. * std::abs(quadratic_) * std::max(std::abs(from), std::abs(to));
}

Periodic::Periodic(Pointer function, const double begin, const double end)
    : function_(std::move(function)), begin_(begin), length_(end - begin)
{
  if (!(end > begin))
    throw std::invalid_argument("a period ends after its beginning");
  whole_ = function_->integral(begin, end);
}

double Periodic::within(const double x) const
{
  const double at = x - length_ * std::floor((x - begin_) / length_);
  return std::clamp(at, begin_, std::nextafter(begin_ + length_, begin_));
}

double Periodic::primitive(const double x) const
{
  return whole_ * std::floor((x - begin_) / length_) + function_->integral(begin_, within(x));
}

double Periodic::integral(const double from, const double to) const
{
  return primitive(to) - primitive(from);
}

std::vector<double> Periodic::breakpoints(const double from, const double to) const
{
  if (!std::isfinite(to - from) || (to - from) / length_ > most_periods)
    return {};
  std::vector<double> in_one = function_->breakpoints(begin_, begin_ + length_), found;
  in_one.insert(in_one.begin(), begin_);
  for (double period = std::floor((from - begin_) / length_); begin_ + period * length_ < to;
       period += 1.)
    for (const double x : in_one)
      if (const double at = x + period * length_; from < at && at < to)
        found.push_back(at);
  return found;
}

double Periodic::largest(double, double) const
{
  return function_->largest(begin_, begin_ + length_);
}

double Periodic::steepest(double, double) const
{
  return function_->steepest(begin_, begin_ + length_);
}

Fluctuating::Fluctuating(Pointer speed, Pointer of_angle, const double start)
    : speed_(std::move(speed)), of_angle_(std::move(of_angle)), start_(start)
{
}

double Fluctuating::value(const double x) const
{
  return speed_->value(x) * (1. + of_angle_->value(angle(x)));
}

double Fluctuating::derivative(const double x) const
{
  const double speed = speed_->value(x), at = angle(x);
  return speed_->derivative(x) * (1. + of_angle_->value(at)) +
         speed * speed * of_angle_->derivative(at);
}

double Fluctuating::integral(const double from, const double to) const
{
  return speed_->integral(from, to) + of_angle_->integral(angle(from), angle(to));
}

std::vector<double> Fluctuating::breakpoints(const double from, const double to) const
{
  return speed_->breakpoints(from, to); // harmonics have none
}

double Fluctuating::largest(const double from, const double to) const
{
  return speed_->largest(from, to) * (1. + of_angle_->largest(angle(from), angle(to)));
}

double Fluctuating::steepest(const double from, const double to) const
{
  const double speed = speed_->largest(from, to), first = angle(from), last = angle(to);
  return speed_->steepest(from, to) * (1. + of_angle_->largest(first, last)) +
         speed * speed * of_angle_->steepest(first, last);
}
} // namespace chaindrive::functions
