// SPDX-License-Identifier: LGPL-2.1-or-later
// How certain levels are. Mean squares of the parts of a record add up to those of its lines, with
// weighting A as well, and tell which part a tone is in. Intervals contain the level of white
// noise, which is known, and that of impacts of random energy, in 95 of 100 records; they are as
// wide as the degrees of freedom of the noise ask for; what recurs in each batch is no uncertainty.
#include <chaindrive/acoustics/spectrum.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace chaindrive::acoustics;

namespace
{
constexpr double pi = dealii::numbers::PI, step = 2e-5; // s

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

double mean_of(const std::vector<double> &values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

std::vector<double> white_noise(std::mt19937 &random, const std::size_t n)
{
  std::normal_distribution<> normal(0., 0.2);
  std::vector<double>        record(n);
  std::generate(record.begin(), record.end(), [&] { return normal(random); });
  return record;
}

void parts()
{
  std::mt19937   random(1);
  const auto     record   = white_noise(random, 12 * 173);
  const Spectrum spectrum = make_spectrum(record, step);
  double         worst    = 0.;
  for (const double highest : {3e3, 20e3, 1e5})
    {
      const auto off = [&](const Weighting weighting, const double wanted) {
        const auto found = mean_squares_of_parts(record, step, 12, highest, weighting);
        return found.size() == 12 ? std::abs(mean_of(found) / wanted - 1.) : 1.;
      };
      worst = std::max({worst,
                        off(Weighting::none, mean_square(spectrum, highest)),
                        off(Weighting::a, a_weighted_mean_square(spectrum, highest))});
    }
  verdict("parts add up to the mean squares of the lines, to 1e-12", worst < 1e-12);

  constexpr std::size_t n = 200;
  std::vector<double>   tone(6 * n, 0.);
  for (std::size_t i = 2 * n; i < 3 * n; ++i)
    tone[i] = 0.3 * std::sin(2. * pi * 10. * i / n);
  const auto found = mean_squares_of_parts(tone, step, 6, 1e5, Weighting::none);
  double     off   = 0.;
  for (std::size_t k = 0; k < 6; ++k)
    off = std::max(off, std::abs(found[k] - (k == 2 ? 0.045 : 0.)));
  verdict("a tone is in its part, to 1e-12", off < 1e-12);
}

constexpr unsigned int n_draws = 2000;

void white()
{
  constexpr std::size_t n_parts = 12, n = 60 * n_parts, n_lines = n / 8; // up to a quarter
  const double          highest   = (n_lines + 0.5) / (n * step);
  const double          truth     = level(0.04 * n_lines / (n / 2.));
  unsigned int          contained = 0;
  double                widths    = 0.;
  std::mt19937          random(2);
  for (unsigned int draw = 0; draw < n_draws; ++draw)
    {
      const auto   record  = white_noise(random, n);
      const auto   squares = mean_squares_of_parts(record, step, n_parts, highest, Weighting::none);
      const double half    = level_uncertainty(squares);
      contained += std::abs(level(mean_of(squares)) - truth) <= half ? 1 : 0;
      widths += half / n_draws;
    }
  const double share = double(contained) / n_draws;
  verdict("white noise: 95 of 100 intervals contain its level", share > 0.93 && share < 0.99);
  // two degrees of freedom per line; Student's 0.975 quantile of 11 is 2.201; neighbours may seem
  // to be correlated
  const double wanted = 10. / std::log(10.) * 2.201 * std::sqrt(2. / (2. * n_lines));
  verdict("and are as wide as their lines ask for, or up to a third wider",
          widths > wanted && widths < 1.33 * wanted);
}

/// Energies that scatter as much as their mean.
void impacts()
{
  std::mt19937                    random(3);
  std::exponential_distribution<> energy(5.);
  unsigned int                    contained = 0;
  for (unsigned int draw = 0; draw < n_draws; ++draw)
    {
      std::vector<double> squares(40);
      std::generate(squares.begin(), squares.end(), [&] { return energy(random); });
      contained +=
          std::abs(level(mean_of(squares)) - level(0.2)) <= level_uncertainty(squares) ? 1 : 0;
    }
  const double share = double(contained) / n_draws;
  verdict("random impacts: 93 to 99 of 100", share > 0.93 && share < 0.99);
}

void batches()
{
  std::vector<double> squares;
  for (unsigned int i = 0; i < 40; ++i)
    squares.push_back(1. + 0.5 * std::sin(0.5 * pi * i));
  verdict("what recurs in each batch is no uncertainty",
          level_uncertainty(squares, 4) < 1e-12 && level_uncertainty(squares, 3) > 0.1);
  verdict("three parts, or silence: no interval",
          std::isnan(level_uncertainty({1., 2., 3.})) &&
              std::isnan(level_uncertainty(std::vector<double>(8, 0.))) &&
              std::isnan(level_uncertainty(std::vector<double>(7, 1.), 2)));
}
} // namespace

int main()
{
  parts();
  white();
  impacts();
  batches();
}
