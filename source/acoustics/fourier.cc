// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/acoustics/fourier.h>

#include <fftw3.h>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace chaindrive::acoustics
{
namespace
{
struct Destroy
{
  void operator()(const fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, Destroy>;

fftw_complex *raw(std::vector<std::complex<double>> &values)
{
  return reinterpret_cast<fftw_complex *>(values.data());
}
} // namespace

std::vector<std::complex<double>> fourier(const std::vector<double> &values)
{
  std::vector<double>               copy = values;
  std::vector<std::complex<double>> coefficients(values.size() / 2 + 1);
  if (values.empty())
    throw std::logic_error("fourier: no values");
  // estimated plans are the same in every run
  const Plan plan(fftw_plan_dft_r2c_1d(
      static_cast<int>(copy.size()), copy.data(), raw(coefficients), FFTW_ESTIMATE));
  fftw_execute(plan.get());
  return coefficients;
}

std::vector<double> inverse_fourier(std::vector<std::complex<double>> coefficients,
                                    const std::size_t                 n)
{
  if (n == 0 || coefficients.size() != n / 2 + 1)
    throw std::logic_error("inverse_fourier: another number of coefficients");
  std::vector<double> values(n);
  const Plan          plan(
      fftw_plan_dft_c2r_1d(static_cast<int>(n), raw(coefficients), values.data(), FFTW_ESTIMATE));
  fftw_execute(plan.get());
  for (double &value : values)
    value /= static_cast<double>(n);
  return values;
}
} // namespace chaindrive::acoustics
