// SPDX-License-Identifier: LGPL-2.1-or-later
// Spectra: Parseval; a tone is one line; harmonics over whole periods do not leak; an impulse train
// has equal lines, whose sums in third octaves are those of their shares; the level of a tone with
// weighting A.
#include <chaindrive/acoustics/fourier.h>
#include <chaindrive/acoustics/spectrum.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace chaindrive::acoustics;

namespace
{
constexpr double pi = dealii::numbers::PI;

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

double sum(const std::vector<double> &values)
{
  double total = 0.;
  for (const double value : values)
    total += value;
  return total;
}

void parseval()
{
  double                     worst = 0., back = 0.;
  std::mt19937               random(1);
  std::normal_distribution<> normal(0.3, 1.);
  for (const std::size_t n : {1, 2, 7, 1000, 1735, 4096})
    {
      std::vector<double> record(n);
      double              square = 0.;
      for (double &value : record)
        {
          value = normal(random);
          square += value * value / n;
        }
      worst = std::max(worst, std::abs(sum(make_spectrum(record, 1e-5).lines) / square - 1.));
      const auto again = inverse_fourier(fourier(record), n);
      for (std::size_t i = 0; i < n; ++i)
        back = std::max(back, std::abs(again[i] - record[i]));
    }
  verdict("Parseval to 1e-12", worst < 1e-12);
  verdict("there and back to 1e-12", back < 1e-12);
}

/// Five pitch periods of 288.25 Hz with orders 1, 3 and 40 of amplitudes 1, 0.5 and 0.1 Pa.
void harmonics()
{
  const double        frequency = 288.25;
  const std::size_t   n         = 5 * 350;
  const double        step      = 5. / frequency / n;
  std::vector<double> record(n);
  for (std::size_t i = 0; i < n; ++i)
    for (const auto &[order, amplitude] : {std::pair(1, 1.), {3, 0.5}, {40, 0.1}})
      record[i] += amplitude * std::cos(2. * pi * order * frequency * step * i + order);
  const Spectrum s      = make_spectrum(record, step);
  const auto     orders = order_lines(s, 5, 22e3);
  std::cout << "lines " << s.spacing << " Hz apart; orders 1 to 3: " << orders[0] << ' '
            << std::round(1e12 * orders[1]) << ' ' << orders[2] << ", 40: " << orders[39]
            << ", in all " << orders.size() << '\n';
  double elsewhere = 0.;
  for (std::size_t k = 0; k < s.lines.size(); ++k)
    if (k != 5 && k != 15 && k != 200)
      elsewhere = std::max(elsewhere, s.lines[k]);
  verdict("nothing leaks, to 1e-24", elsewhere < 1e-24);
  std::cout << "level " << level(mean_square(s, 22e3)) << " dB, without order 40 "
            << level(mean_square(s, 5e3)) << " dB\n";
  const double by_hand = 0.5 * (std::pow(10., 0.1 * a_weighting(frequency)) +
                                0.25 * std::pow(10., 0.1 * a_weighting(3. * frequency)) +
                                0.01 * std::pow(10., 0.1 * a_weighting(40. * frequency)));
  std::cout << "weighted " << a_weighted_mean_square(s, 22e3) / by_hand << " of that by hand\n";
}

/// A pulse of unit area per period: lines of 2/T^2 each.
void impulse_train()
{
  const std::size_t   period = 500, n = 4 * period;
  const double        step = 1e-5, T = period * step;
  std::vector<double> record(n, 0.);
  for (std::size_t i = 3; i < n; i += period)
    record[i] = 1. / step;
  const Spectrum s     = make_spectrum(record, step);
  const auto     lines = order_lines(s, 4, 20e3);
  double         worst = 0.;
  for (const double line : lines)
    worst = std::max(worst, std::abs(0.5 * line * T * T - 1.));
  verdict("all orders of an impulse train are 2 over the square of its period",
          lines.size() == 100 && worst < 1e-12);
  // a white record, one line in four: a band takes its width over 200 Hz of them, within one
  const auto bands = bands_within(s, 22.4e3);
  const auto parts = in_bands(s, bands);
  double     off   = 0.;
  for (std::size_t i = 0; i < bands.size(); ++i)
    off = std::max(
        off, std::abs(0.5 * T * T * parts[i] - (bands[i].high - bands[i].low) / (4. * s.spacing)));
  verdict("bands take their widths of them, to one line", off < 1.);
  std::cout << "bands from " << bands.front().name << " to " << bands.back().name << ", with 20 us "
            << bands_within(make_spectrum(std::vector<double>(1000, 1.), 2e-5), 2e4).back().name
            << '\n';
  // edges between the bands lose nothing
  double       all = 0.;
  const double low = bands.front().low / s.spacing, high = bands.back().high / s.spacing;
  for (std::size_t k = 1; k < s.lines.size(); ++k)
    all += s.lines[k] * std::max(0., std::min(high, k + 0.5) - std::max(low, k - 0.5));
  verdict("bands together hold all lines, to 1e-12", std::abs(sum(parts) / all - 1.) < 1e-12);
}
} // namespace

int main()
{
  parseval();
  harmonics();
  impulse_train();
}
