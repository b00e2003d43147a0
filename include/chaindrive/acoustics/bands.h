// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace chaindrive::acoustics
{
constexpr double reference_pressure = 20e-6; ///< of levels, Pa

/// Level re 20 uPa [dB] of a mean square pressure [Pa2]; minus infinity of silence.
double level(double mean_square);

/// Half of the 95 % confidence interval [dB] of the level of the mean of @p mean_squares [Pa2],
/// which those of successive equal times are, at least @p least of them in each batch: the
/// uncertainty of the mean (uncertainty_of_mean()) over the mean, times 10 / ln 10, by which the
/// level changes with the logarithm of its mean square. Not a number with too few of them, and of
/// silence.
double level_uncertainty(const std::vector<double> &mean_squares, std::size_t least = 1);

/// Frequency weighting A [dB] at @p frequency [Hz], positive: IEC 61672-1, 5.5, with the offset
/// that makes it zero at 1 kHz.
double a_weighting(double frequency);

/// A third-octave band of IEC 61260-1, base 10: its exact middle is 1 kHz times 10^(n/10).
struct Band
{
  double      low, middle, high; ///< Hz
  std::string name;              ///< the nominal middle, such as "315" or "3.15k"
};

/// The bands whose middles lie between @p from and @p to [Hz], within a twentieth of a band, as
/// nominal ones are.
std::vector<Band> third_octaves(double from, double to);
} // namespace chaindrive::acoustics
