// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace chaindrive::acoustics
{
/// Coefficients 0 ... n/2 of the discrete Fourier transform of @p values, not scaled: the sum of
/// values[j] exp(-2 pi i j k / n).
std::vector<std::complex<double>> fourier(const std::vector<double> &values);

/// The @p n real values whose coefficients 0 ... n/2, divided by n, are @p coefficients: fourier()
/// backwards. There must be n/2 + 1 of them.
std::vector<double> inverse_fourier(std::vector<std::complex<double>> coefficients, std::size_t n);
} // namespace chaindrive::acoustics
