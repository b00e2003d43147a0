// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/acoustics/fourier.h>
#include <chaindrive/acoustics/spectrum.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace chaindrive::acoustics
{
namespace
{
/// Sum of the lines 1, 2, ... up to @p highest, times @p weight at their frequencies.
template <typename Weight>
double sum_of_lines(const Spectrum &spectrum, const double highest, const Weight &weight)
{
  double sum = 0.;
  for (std::size_t k = 1; k < spectrum.lines.size() && spectrum.frequency(k) <= highest; ++k)
    sum += weight(spectrum.frequency(k)) * spectrum.lines[k];
  return sum;
}

/// How much of line @p k, from half a line below it to half a line above, lies within @p band.
double share_of_line(const Band &band, const std::size_t k, const double spacing)
{
  const double middle = static_cast<double>(k);
  const double from   = std::max(band.low / spacing, middle - 0.5);
  const double to     = std::min(band.high / spacing, middle + 0.5);
  return std::max(0., to - from);
}
} // namespace

Spectrum make_spectrum(const std::vector<double> &record, const double step)
{
  if (record.empty() || !(step > 0.))
    throw std::logic_error("make_spectrum: no record");
  const std::size_t n            = record.size();
  const auto        coefficients = fourier(record);
  Spectrum          spectrum{1. / (step * static_cast<double>(n)), {}};
  spectrum.lines.reserve(coefficients.size());
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    {
      // all others stand for a negative frequency too
      const double twice = k == 0 || 2 * k == n ? 1. : 2.;
      spectrum.lines.push_back(twice * std::norm(coefficients[k]) /
                               (static_cast<double>(n) * static_cast<double>(n)));
    }
  return spectrum;
}

double mean_square(const Spectrum &spectrum, const double highest)
{
  return sum_of_lines(spectrum, highest, [](double) { return 1.; });
}

double a_weighted_mean_square(const Spectrum &spectrum, const double highest)
{
  return sum_of_lines(spectrum, highest, [](const double frequency) {
    return std::pow(10., 0.1 * a_weighting(frequency));
  });
}

std::vector<double> mean_squares_of_parts(const std::vector<double> &record,
                                          const double               step,
                                          const std::size_t          n,
                                          const double               highest,
                                          const Weighting            weighting)
{
  if (n == 0 || record.size() < n || record.size() % n != 0)
    throw std::logic_error("mean_squares_of_parts: no whole parts");
  auto         lines   = fourier(record);
  const double spacing = 1. / (step * static_cast<double>(record.size()));
  for (std::size_t k = 0; k < lines.size(); ++k)
    {
      const double frequency = spacing * static_cast<double>(k);
      if (k == 0 || frequency > highest)
        lines[k] = 0.;
      else if (weighting == Weighting::a)
        lines[k] *= std::pow(10., 0.05 * a_weighting(frequency));
    }
  const std::vector<double> heard  = inverse_fourier(std::move(lines), record.size());
  const auto                length = static_cast<std::ptrdiff_t>(record.size() / n);
  std::vector<double>       parts;
  parts.reserve(n);
  for (auto begin = heard.begin(); begin != heard.end(); begin += length)
    parts.push_back(std::inner_product(begin, begin + length, begin, 0.) /
                    static_cast<double>(length));
  return parts;
}

std::vector<double> in_bands(const Spectrum &spectrum, const std::vector<Band> &bands)
{
  std::vector<double> sums;
  sums.reserve(bands.size());
  for (const Band &band : bands)
    {
      double            sum   = 0.;
      const double      first = std::floor(band.low / spectrum.spacing);
      const std::size_t begin = std::max<std::size_t>(1, static_cast<std::size_t>(first));
      for (std::size_t k = begin; k < spectrum.lines.size(); ++k)
        {
          if (spectrum.frequency(k) > band.high + spectrum.spacing)
            break;
          sum += share_of_line(band, k, spectrum.spacing) * spectrum.lines[k];
        }
      sums.push_back(sum);
    }
  return sums;
}

std::vector<Band> bands_within(const Spectrum &spectrum, const double highest)
{
  std::vector<Band> bands = third_octaves(20., 20e3);
  const auto        out   = [&](const Band &band) {
    return band.low < 0.5 * spectrum.spacing || band.high > highest * (1. + 1e-9);
  };
  bands.erase(std::remove_if(bands.begin(), bands.end(), out), bands.end());
  return bands;
}

std::vector<double>
order_lines(const Spectrum &spectrum, const unsigned int periods, const double highest)
{
  if (periods == 0)
    throw std::logic_error("order_lines: no period");
  std::vector<double> orders;
  for (std::size_t k = periods; k < spectrum.lines.size() && spectrum.frequency(k) <= highest;
       k += periods)
    orders.push_back(spectrum.lines[k]);
  return orders;
}
} // namespace chaindrive::acoustics
