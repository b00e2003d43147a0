// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/acoustics/bands.h>
#include <chaindrive/utilities/batch_means.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace chaindrive::acoustics
{
namespace
{
/// Response of weighting A but for its offset.
double a_response(const double frequency)
{
  // poles of IEC 61672-1, annex E, Hz
  constexpr double f1 = 20.598997, f2 = 107.65265, f3 = 737.86223, f4 = 12194.217;
  const double     s = frequency * frequency;
  return f4 * f4 * s * s /
         ((s + f1 * f1) * std::sqrt((s + f2 * f2) * (s + f3 * f3)) * (s + f4 * f4));
}

std::string nominal(const int n)
{
  // of the decade from 10^n to 10^(n + 1)
  static const char *const digits[10] = {
      "1", "1.25", "1.6", "2", "2.5", "3.15", "4", "5", "6.3", "8"};
  const int    decade = static_cast<int>(std::floor(n / 10.)); // of kHz
  const double value  = std::stod(digits[n - 10 * decade]) * std::pow(10., decade);
  std::string  text   = std::to_string(value >= 1. ? value : 1e3 * value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.')
    text.pop_back();
  return value >= 1. ? text + "k" : text;
}
} // namespace

double level(const double mean_square)
{
  return 10. * std::log10(mean_square / (reference_pressure * reference_pressure));
}

double level_uncertainty(const std::vector<double> &mean_squares, const std::size_t least)
{
  const double mean = std::accumulate(mean_squares.begin(), mean_squares.end(), 0.) /
                      static_cast<double>(mean_squares.size());
  return 10. / std::log(10.) * uncertainty_of_mean(mean_squares, least) / mean;
}

double a_weighting(const double frequency)
{
  if (!(frequency > 0.))
    throw std::logic_error("a_weighting: no frequency");
  return 20. * std::log10(a_response(frequency) / a_response(1e3));
}

std::vector<Band> third_octaves(const double from, const double to)
{
  if (!(from > 0.) || !(to >= from))
    throw std::logic_error("third_octaves: no range of frequencies");
  std::vector<Band> bands;
  const auto place = [](const double frequency) { return 10. * std::log10(1e-3 * frequency); };
  const int  last  = static_cast<int>(std::floor(place(to) + 0.05));
  for (int n = static_cast<int>(std::ceil(place(from) - 0.05)); n <= last; ++n)
    {
      const double middle = 1e3 * std::pow(10., 0.1 * n), half = std::pow(10., 0.05);
      bands.push_back({middle / half, middle, middle * half, nominal(n)});
    }
  return bands;
}
} // namespace chaindrive::acoustics
