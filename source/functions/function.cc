// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/functions/function.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace chaindrive::functions
{
namespace
{
using dealii::numbers::PI;

/// Those of @p places in (@p from, @p to).
std::vector<double> within(const std::vector<double> &places, const double from, const double to)
{
  std::vector<double> found;
  for (const double x : places)
    if (from < x && x < to)
      found.push_back(x);
  return found;
}

/// The breakpoints of several functions in rising order, each once.
template <typename Functions>
std::vector<double> merged(const Functions &functions, const double from, const double to)
{
  std::vector<double> all;
  for (const Pointer &function : functions)
    {
      const std::vector<double> of_one = function->breakpoints(from, to);
      all.insert(all.end(), of_one.begin(), of_one.end());
    }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The sum of what @p of tells of each function.
template <typename Of>
double total(const std::vector<Pointer> &functions, const Of &of)
{
  double sum = 0.;
  for (const Pointer &function : functions)
    sum += of(*function);
  return sum;
}

void require(const bool good, const char *what)
{
  if (!good)
    throw std::invalid_argument(what);
}

bool rises(const std::vector<double> &x)
{
  return std::adjacent_find(x.begin(), x.end(), [](double a, double b) { return !(a < b); }) ==
         x.end();
}
} // namespace

std::vector<double> Function::breakpoints(double, double) const { return {}; }

double last_breakpoint(const Function &function, const double otherwise)
{
  constexpr double          infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> all      = function.breakpoints(-infinity, infinity);
  return all.empty() ? otherwise : all.back();
}

double Constant::largest(double, double) const { return std::abs(value_); }

double Constant::steepest(double, double) const { return 0.; }

Ramp::Ramp(const double level, const double start, const double length, const Rise rise)
    : level_(level), start_(start), length_(length), rise_(rise)
{
  require(length >= 0., "a ramp of negative length");
}

double Ramp::value(const double x) const
{
  const double t = x - start_;
  if (t >= length_)
    return level_;
  if (t <= 0.)
    return 0.;
  const double s = t / length_;
  return level_ * (rise_ == Rise::cosine ? 0.5 * (1. - std::cos(PI * s)) : s);
}

double Ramp::derivative(const double x) const
{
  const double t = x - start_;
  if (t < 0. || t >= length_)
    return 0.;
  return level_ / length_ * (rise_ == Rise::cosine ? 0.5 * PI * std::sin(PI * t / length_) : 1.);
}

double Ramp::primitive(const double x) const
{
  const double t = x - start_;
  if (t >= length_) // both rises have covered half of what the full value would have
    return level_ * (t - 0.5 * length_);
  if (t <= 0.)
    return 0.;
  const double s = t / length_;
  return level_ * length_ *
         (rise_ == Rise::cosine ? 0.5 * s - std::sin(PI * s) / (2. * PI) : 0.5 * s * s);
}

double Ramp::integral(const double from, const double to) const
{
  return primitive(to) - primitive(from);
}

std::vector<double> Ramp::breakpoints(const double from, const double to) const
{
  if (length_ == 0.)
    return within({start_}, from, to);
  return within({start_, start_ + length_}, from, to);
}

double Ramp::largest(const double from, const double to) const
{
  return std::max(std::abs(value(from)), std::abs(value(to)));
}

double Ramp::steepest(const double from, const double to) const
{
  // steepest in the middle, or as near to it as the interval goes
  const double middle = std::clamp(start_ + 0.5 * length_, from, to);
  return std::abs(derivative(middle));
}

Steps::Steps(const double first, std::vector<double> places, std::vector<double> values)
    : places_(std::move(places)), values_(std::move(values))
{
  require(places_.size() == values_.size(), "as many values as places of steps");
  require(rises(places_), "places of steps must rise");
  values_.insert(values_.begin(), first);
}

double Steps::value(const double x) const
{
  return values_[std::upper_bound(places_.begin(), places_.end(), x) - places_.begin()];
}

double Steps::integral(const double from, const double to) const
{
  if (to < from)
    return -integral(to, from);
  double sum = 0., x = from;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i] > x && x < to)
      {
        const double next = std::min(places_[i], to);
        sum += values_[i] * (next - x);
        x = next;
      }
  return sum + values_.back() * (to - x);
}

std::vector<double> Steps::breakpoints(const double from, const double to) const
{
  return within(places_, from, to);
}

double Steps::largest(const double from, const double to) const
{
  const auto first = std::upper_bound(places_.begin(), places_.end(), from) - places_.begin();
  const auto last  = std::upper_bound(places_.begin(), places_.end(), to) - places_.begin();
  double     most  = 0.;
  for (auto i = first; i <= last; ++i)
    most = std::max(most, std::abs(values_[i]));
  return most;
}

double Steps::steepest(double, double) const { return 0.; }

Harmonics::Harmonics(std::vector<Harmonic> terms) : terms_(std::move(terms))
{
  for (const Harmonic &term : terms_)
    require(term.order != 0., "a harmonic of order 0");
}

double Harmonics::value(const double x) const
{
  double sum = 0.;
  for (const Harmonic &term : terms_)
    sum += term.amplitude * std::cos(term.order * x + term.phase);
  return sum;
}

double Harmonics::derivative(const double x) const
{
  double sum = 0.;
  for (const Harmonic &term : terms_)
    sum -= term.amplitude * term.order * std::sin(term.order * x + term.phase);
  return sum;
}

double Harmonics::integral(const double from, const double to) const
{
  // sin a - sin b = 2 cos((a + b)/2) sin((a - b)/2) loses nothing when both are near
  double sum = 0.;
  for (const Harmonic &term : terms_)
    sum += term.amplitude / term.order * 2. *
           std::cos(0.5 * term.order * (to + from) + term.phase) *
           std::sin(0.5 * term.order * (to - from));
  return sum;
}

double Harmonics::largest(double, double) const
{
  double sum = 0.;
  for (const Harmonic &term : terms_)
    sum += std::abs(term.amplitude);
  return sum;
}

double Harmonics::steepest(double, double) const
{
  double sum = 0.;
  for (const Harmonic &term : terms_)
    sum += std::abs(term.amplitude * term.order);
  return sum;
}

Sum::Sum(std::vector<Pointer> terms) : terms_(std::move(terms)) {}

double Sum::value(const double x) const
{
  return total(terms_, [=](const Function &term) { return term.value(x); });
}

double Sum::derivative(const double x) const
{
  return total(terms_, [=](const Function &term) { return term.derivative(x); });
}

double Sum::integral(const double from, const double to) const
{
  return total(terms_, [=](const Function &term) { return term.integral(from, to); });
}

std::vector<double> Sum::breakpoints(const double from, const double to) const
{
  return merged(terms_, from, to);
}

double Sum::largest(const double from, const double to) const
{
  return total(terms_, [=](const Function &term) { return term.largest(from, to); });
}

double Sum::steepest(const double from, const double to) const
{
  return total(terms_, [=](const Function &term) { return term.steepest(from, to); });
}

bool Sum::is_constant() const
{
  return std::all_of(
      terms_.begin(), terms_.end(), [](const Pointer &term) { return term->is_constant(); });
}

Product::Product(Pointer first, Pointer second)
    : first_(std::move(first)), second_(std::move(second))
{
}

double Product::value(const double x) const { return first_->value(x) * second_->value(x); }

double Product::derivative(const double x) const
{
  return first_->derivative(x) * second_->value(x) + first_->value(x) * second_->derivative(x);
}

double Product::integral(const double from, const double to) const
{
  if (first_->is_constant())
    return first_->value(from) * second_->integral(from, to);
  if (second_->is_constant())
    return second_->value(from) * first_->integral(from, to);
  if (to < from)
    return -integral(to, from);
  std::vector<double> ends = breakpoints(from, to);
  ends.push_back(to);
  double sum = 0., begin = from;
  for (const double end : ends)
    {
      // the rule has no node at the ends, where the next piece may begin
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          [this](const double x) { return value(x); }, begin, end, 15, 1e-13);
      begin = end;
    }
  return sum;
}

std::vector<double> Product::breakpoints(const double from, const double to) const
{
  return merged(std::array<Pointer, 2>{{first_, second_}}, from, to);
}

double Product::largest(const double from, const double to) const
{
  return first_->largest(from, to) * second_->largest(from, to);
}

double Product::steepest(const double from, const double to) const
{
  return first_->steepest(from, to) * second_->largest(from, to) +
         first_->largest(from, to) * second_->steepest(from, to);
}

bool Product::is_constant() const { return first_->is_constant() && second_->is_constant(); }
} // namespace chaindrive::functions
