// SPDX-License-Identifier: LGPL-2.1-or-later
// Weighting A at the exact middles of octaves as in the table of IEC 61672-1, to its tenth of a
// decibel; third octaves of IEC 61260-1: nominal names, ratios of edges, no gaps; levels.
#include <chaindrive/acoustics/bands.h>

#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

using namespace chaindrive::acoustics;

int main()
{
  const std::vector<std::pair<int, double>> table = {{-15, -39.4},
                                                     {-12, -26.2},
                                                     {-9, -16.1},
                                                     {-6, -8.6},
                                                     {-3, -3.2},
                                                     {0, 0.},
                                                     {3, 1.2},
                                                     {6, 1.},
                                                     {9, -1.1},
                                                     {12, -6.6}};
  double                                    worst = 0.;
  for (const auto &[n, weight] : table)
    worst = std::max(worst, std::abs(a_weighting(1e3 * std::pow(10., 0.1 * n)) - weight));
  std::cout << "weighting A as in the table to 0.05 dB: " << (worst < 0.05 + 1e-3 ? "yes" : "NO")
            << '\n';

  const auto bands = third_octaves(20., 20e3);
  for (const Band &band : bands)
    std::cout << band.name << ' ';
  std::cout << '\n';
  double gap = 0., ratio = 0.;
  for (std::size_t i = 0; i < bands.size(); ++i)
    {
      ratio = std::max(ratio, std::abs(bands[i].high / bands[i].low - std::pow(10., 0.1)));
      if (i > 0)
        gap = std::max(gap, std::abs(bands[i].low / bands[i - 1].high - 1.));
    }
  std::cout << "a tenth of a decade each, without gaps: "
            << (ratio < 1e-12 && gap < 1e-12 ? "yes" : "NO") << '\n';
  std::cout << "1 Pa: " << std::round(100. * level(1.)) / 100. << " dB\n";
}
