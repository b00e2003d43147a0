// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/acoustics/fourier.h>
#include <chaindrive/acoustics/record.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace chaindrive::acoustics
{
Regular::Regular(const std::vector<double> &time) : grid_{0., 0., time.size()}
{
  const std::size_t n = time.size();
  if (n < n_neighbours || !(time.back() > time.front()))
    throw std::logic_error("Regular: not enough times");
  grid_.start = time.front();
  grid_.step  = (time.back() - time.front()) / static_cast<double>(n - 1);
  for (std::size_t i = 0; i < n; ++i)
    {
      const double at = grid_.time(i);
      largest_shift_  = std::max(largest_shift_, std::abs(time[i] - at) / grid_.step);
      // three neighbours on either side, but at the ends
      const std::size_t first =
          std::min(i < n_neighbours / 2 ? 0 : i - n_neighbours / 2 + 1, n - n_neighbours);
      first_.push_back(first);
      for (std::size_t j = first; j < first + n_neighbours; ++j)
        {
          double weight = 1.;
          for (std::size_t m = first; m < first + n_neighbours; ++m)
            if (m != j)
              weight *= (at - time[m]) / (time[j] - time[m]);
          weights_.push_back(weight);
        }
    }
}

std::vector<double> Regular::operator()(const std::vector<double> &values) const
{
  if (values.size() != grid_.size)
    throw std::logic_error("Regular: values and times do not belong together");
  std::vector<double> result(values.size(), 0.);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < n_neighbours; ++j)
      result[i] += weights_[n_neighbours * i + j] * values[first_[i] + j];
  return result;
}

std::vector<double> differences(const std::vector<double> &velocity, const double step)
{
  std::vector<double> result;
  result.reserve(velocity.size());
  for (std::size_t i = 0; i + 1 < velocity.size(); ++i)
    result.push_back((velocity[i + 1] - velocity[i]) / step);
  return result;
}

std::vector<double> refine(const std::vector<double> &record,
                           const double               step,
                           const std::size_t          n,
                           const Response            &response)
{
  if (record.empty() || n == 0)
    throw std::logic_error("refine: nothing to refine");
  std::vector<double> both = record;
  both.insert(both.end(), record.rbegin(), record.rend());
  auto         coefficients = fourier(both);
  const double spacing      = 1. / (step * static_cast<double>(both.size()));
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    coefficients[k] *= static_cast<double>(n) * response(spacing * static_cast<double>(k));
  coefficients.resize(record.size() * n + 1);
  std::vector<double> fine = inverse_fourier(std::move(coefficients), both.size() * n);
  fine.resize((record.size() - 1) * n + 1);
  return fine;
}

double passed(const double frequency, const double highest, const double averaged)
{
  const double above = (frequency / highest - 1.) / 0.1;
  if (above >= 1.)
    return 0.;
  const double x    = dealii::numbers::PI * frequency * averaged;
  const double mean = x < 1e-6 ? 1. : std::sin(x) / x;
  return (above <= 0. ? 1. : 0.5 * (1. + std::cos(dealii::numbers::PI * above))) / mean;
}

std::complex<double>
sphere_response(const double frequency, const double radius, const double speed_of_sound)
{
  const double ka = 2. * dealii::numbers::PI * frequency * radius / speed_of_sound;
  return 2. * std::polar(1., ka) / std::complex<double>(2. - ka * ka, 2. * ka);
}
} // namespace chaindrive::acoustics
