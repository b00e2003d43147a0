// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/acoustics/dipole.h>

#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

namespace chaindrive::acoustics
{
/// Takes records from times that are nearly equally far apart, as those of whole steps are, to ones
/// that are: by polynomials through six neighbours.
class Regular
{
public:
  /// @p time [s] grows, and has six values at least.
  explicit Regular(const std::vector<double> &time);

  /// As many equal steps from the first time to the last.
  const Grid &grid() const { return grid_; }

  /// The largest distance of a time from its place in grid(), over the step.
  double largest_shift() const { return largest_shift_; }

  std::vector<double> operator()(const std::vector<double> &values) const;

private:
  static constexpr std::size_t n_neighbours = 6;

  Grid                     grid_;
  double                   largest_shift_ = 0.;
  std::vector<std::size_t> first_;   ///< neighbour, by instant of the grid
  std::vector<double>      weights_; ///< of its neighbours
};

/// Mean accelerations between the instants of @p velocity, whose steps are @p step [s]. That of a
/// picked instant would fold all that is above half the sampling frequency onto what is below.
std::vector<double> differences(const std::vector<double> &velocity, double step);

/// What a frequency [Hz] is multiplied by.
using Response = std::function<std::complex<double>(double)>;

/// @p record, whose samples are @p step [s] apart, with @p n times as many samples, filtered by @p
/// response, which must be zero from half the sampling frequency on. At its ends the record is
/// continued by its mirror image. Sample i becomes sample n i.
std::vector<double>
refine(const std::vector<double> &record, double step, std::size_t n, const Response &response);

/// Response without phase that passes all up to @p highest [Hz] and nothing from a tenth above it
/// on, a half cosine between, over the mean over @p averaged [s] that the record has gone through.
double passed(double frequency, double highest, double averaged);

/// Ratio of the pressure of a rigid sphere of @p radius [m] that oscillates to that of a compact
/// dipole of the same strength, at any distance: 2 exp(i ka) / (2 + 2 i ka - (ka)^2), time as exp(i
/// omega t) (Pierce, Acoustics, 4-2).
std::complex<double> sphere_response(double frequency, double radius, double speed_of_sound);
} // namespace chaindrive::acoustics
