// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/eigenvalue.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/tridiagonal_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace chaindrive
{
namespace
{
/// Largest eigenvalue of the symmetric tridiagonal matrix with @p diagonal and @p beside it, whose
/// last entry leads out of the matrix, and the residual of its vector in the space that Lanczos'
/// method explores: that entry times the last component of the unit eigenvector. An eigenvalue of
/// the whole is no farther away. The vector grows from both ends towards where it is largest
/// (Parlett, Dhillon, Linear Algebra Appl. 267 (1997)).
std::pair<double, double> largest_ritz_value(const std::vector<double> &diagonal,
                                             const std::vector<double> &beside)
{
  const std::size_t                 n = diagonal.size();
  dealii::TridiagonalMatrix<double> ritz(n, /*symmetric*/ true);
  for (std::size_t i = 0; i < n; ++i)
    {
      ritz(i, i) = diagonal[i];
      if (i > 0)
        ritz(i, i - 1) = beside[i - 1];
    }
  ritz.compute_eigenvalues();
  const double value = ritz.eigenvalue(n - 1);

  // pivots of value - ritz from above and from below, positive but for round-off
  const double        least = 1e-16 * std::abs(value) + std::numeric_limits<double>::min();
  std::vector<double> from_above(n), from_below(n);
  for (std::size_t i = 0; i < n; ++i)
    {
      const double coupled = i == 0 ? 0. : beside[i - 1] * beside[i - 1] / from_above[i - 1];
      from_above[i]        = std::max(least, value - diagonal[i] - coupled);
    }
  for (std::size_t i = n; i-- > 0;)
    {
      const double coupled = i + 1 == n ? 0. : beside[i] * beside[i] / from_below[i + 1];
      from_below[i]        = std::max(least, value - diagonal[i] - coupled);
    }
  std::size_t peak = 0;
  const auto  rest = [&](const std::size_t i) {
    return std::abs(from_above[i] + from_below[i] - (value - diagonal[i]));
  };
  for (std::size_t i = 1; i < n; ++i)
    if (rest(i) < rest(peak))
      peak = i;
  double square = 1., last = 1.;
  for (std::size_t i = peak; i-- > 0;)
    {
      last *= beside[i] / from_above[i];
      square += last * last;
    }
  last = 1.;
  for (std::size_t i = peak + 1; i < n; ++i)
    {
      last *= beside[i - 1] / from_below[i];
      square += last * last;
    }
  return {value, beside[n - 1] * last / std::sqrt(square)};
}
} // namespace

double largest_eigenvalue(const std::size_t n, const Product &product)
{
  constexpr double       accepted = 1e-6;
  dealii::Vector<double> before(n), here(n), next(n);
  for (std::size_t i = 0; i < n; ++i)
    here[i] = std::sin(1. + 12.9898 * double(i) * double(i)); // all eigenvectors take part
  here /= here.l2_norm();

  // Round-off makes it find eigenvalues again but none beyond the spectrum. The coefficients of
  // conjugate gradients, the same in exact arithmetic, break down where there are eigenvalues 0.
  std::vector<double>       diagonal, beside;
  std::pair<double, double> found;
  double                    largest = 0.;
  while (diagonal.size() < 2000)
    {
      product(next, here);
      if (!beside.empty())
        next.add(-beside.back(), before);
      diagonal.push_back(next * here);
      next.add(-diagonal.back(), here);
      beside.push_back(next.l2_norm());
      largest              = std::max(largest, diagonal.back());
      const bool exhausted = beside.back() <= 1e-14 * largest; // all eigenvalues are found
      if (exhausted || diagonal.size() % 25 == 0)
        {
          found = largest_ritz_value(diagonal, beside);
          if (exhausted || found.second <= accepted * found.first)
            break;
        }
      before = here;
      here.equ(1. / beside.back(), next);
    }
  return found.first + found.second;
}

Eigenpairs eigenpairs(const dealii::FullMatrix<double> &matrix)
{
  dealii::LAPACKFullMatrix<double> lapack(matrix.m(), matrix.n());
  lapack             = matrix;
  const double bound = 1.01 * lapack.linfty_norm(); // Gershgorin
  Eigenpairs   pairs;
  lapack.compute_eigenvalues_symmetric(-bound, bound, 0., pairs.values, pairs.vectors);
  return pairs;
}
} // namespace chaindrive
