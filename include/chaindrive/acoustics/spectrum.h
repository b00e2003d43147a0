// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/acoustics/bands.h>

#include <cstddef>
#include <vector>

namespace chaindrive::acoustics
{
/// One-sided spectrum of a record: what each line adds to its mean square, so that their sum is the
/// mean square (Parseval). Without a window: a record of whole periods does not leak.
struct Spectrum
{
  double              spacing; ///< of the lines, one over the length of the record, Hz
  std::vector<double> lines;   ///< mean squares; the first is the square of the mean

  double frequency(const std::size_t k) const { return spacing * static_cast<double>(k); } ///< Hz
};

/// That of @p record, whose samples are @p step [s] apart.
Spectrum make_spectrum(const std::vector<double> &record, double step);

/// Mean square of what oscillates, of lines up to @p highest [Hz].
double mean_square(const Spectrum &spectrum, double highest);

/// The same, weighted by A.
double a_weighted_mean_square(const Spectrum &spectrum, double highest);

enum class Weighting
{
  none,
  a
};

/// Mean squares over each of @p n equal parts of @p record, whose samples are @p step [s] apart, of
/// what it has in lines up to @p highest [Hz], weighted. Their mean is mean_square() or
/// a_weighted_mean_square() of its spectrum (Parseval). The number of samples must be a multiple of
/// @p n.
std::vector<double> mean_squares_of_parts(const std::vector<double> &record,
                                          double                     step,
                                          std::size_t                n,
                                          double                     highest,
                                          Weighting                  weighting);

/// Mean square in each of @p bands. A line is spread over the spacing around it; a band takes its
/// share of a line that lies across its edge. The mean of the record is left out.
std::vector<double> in_bands(const Spectrum &spectrum, const std::vector<Band> &bands);

/// The bands of a third octave from 20 Hz to 20 kHz that @p spectrum tells anything of: above half
/// the first line and up to @p highest [Hz].
std::vector<Band> bands_within(const Spectrum &spectrum, double highest);

/// Mean squares of the lines at 1, 2, ... times the frequency of which the record holds @p periods
/// whole periods, up to @p highest [Hz].
std::vector<double> order_lines(const Spectrum &spectrum, unsigned int periods, double highest);
} // namespace chaindrive::acoustics
