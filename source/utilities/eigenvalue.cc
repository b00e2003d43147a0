// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/eigenvalue.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/lapack_templates.h>
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
/// Of the symmetric tridiagonal matrix with @p diagonal and @p beside it, whose last entry leads
/// out of the matrix: the residual of the vector to its largest eigenvalue @p value in the space
/// that Lanczos' method explores, which is that entry times the last component of the unit
/// eigenvector. An eigenvalue of the whole is no farther away. The vector grows from both ends
/// towards where it is largest (Parlett, Dhillon, Linear Algebra Appl. 267 (1997)).
double residual_of(const double               value,
                   const std::vector<double> &diagonal,
                   const std::vector<double> &beside)
{
  const std::size_t n = diagonal.size();

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
  return beside[n - 1] * last / std::sqrt(square);
}

/// Largest eigenvalue of that matrix, and its residual.
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
  return {value, residual_of(value, diagonal, beside)};
}

/// About the same, by bisection (Golub, Van Loan, 8.4: x is above all eigenvalues if no pivot of
/// the matrix less x is positive): work that grows with the matrix, not with its square. No
/// eigenvalue is below @p known, and one is not above it.
std::pair<double, double> about_largest_ritz_value(const std::vector<double> &diagonal,
                                                   const std::vector<double> &beside,
                                                   const double               known)
{
  const std::size_t n     = diagonal.size();
  const auto        above = [&](const double x) {
    double pivot = -1.;
    for (std::size_t i = 0; i < n; ++i)
      {
        pivot = diagonal[i] - x - (i == 0 ? 0. : beside[i - 1] * beside[i - 1] / pivot);
        if (!(pivot < 0.))
          return false;
      }
    return true;
  };
  double low = known, high = known;
  for (std::size_t i = 0; i < n; ++i) // Gershgorin
    high =
        std::max(high, diagonal[i] + (i > 0 ? beside[i - 1] : 0.) + (i + 1 < n ? beside[i] : 0.));
  high *= 1. + 1e-14;
  while (high - low > 4. * std::numeric_limits<double>::epsilon() * high)
    {
      const double middle          = 0.5 * (low + high);
      (above(middle) ? high : low) = middle;
    }
  return {high, residual_of(high, diagonal, beside)};
}
} // namespace

double largest_eigenvalue(const std::size_t n, const Product &product)
{
  constexpr double       accepted = 1e-6;
  constexpr std::size_t  most     = 2000;
  dealii::Vector<double> before(n), here(n), next(n);
  for (std::size_t i = 0; i < n; ++i)
    here[i] = std::sin(1. + 12.9898 * double(i) * double(i)); // all eigenvectors take part
  here /= here.l2_norm();

  // Round-off makes it find eigenvalues again but none beyond the spectrum. The coefficients of
  // conjugate gradients, the same in exact arithmetic, break down where there are eigenvalues 0.
  std::vector<double>       diagonal, beside;
  std::pair<double, double> found;
  double                    largest = 0., about = 0.;
  while (diagonal.size() < most)
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
          // all of LAPACK's eigenvalues, work of the square, where it may be the last time only
          const auto near = about_largest_ritz_value(diagonal, beside, std::max(about, largest));
          about           = (1. - 1e-12) * near.first;
          if (exhausted || diagonal.size() == most || near.second < 1.01 * accepted * near.first)
            {
              found = largest_ritz_value(diagonal, beside);
              if (exhausted || found.second <= accepted * found.first)
                break;
            }
        }
      before = here;
      here.equ(1. / beside.back(), next);
    }
  return found.first + found.second;
}

Eigenpairs eigenpairs(const dealii::FullMatrix<double> &matrix, const double up_to)
{
  using Integer                      = dealii::types::blas_int;
  const std::size_t                n = matrix.m();
  dealii::LAPACKFullMatrix<double> lapack(n, n);
  lapack             = matrix;
  const double bound = 1.01 * lapack.linfty_norm(); // Gershgorin

  // compute_eigenvalues_symmetric() of deal.II writes on the console where LAPACK says that a
  // vector of a cluster has not converged, however little it lacks
  const char           vectors = 'V', values = 'V', upper = 'U';
  const Integer        size = static_cast<Integer>(n), none = 1;
  const double         from = -bound, to = std::min(bound, up_to), tolerance = 0.;
  std::vector<double>  found(n), of_values(n * n), work(1);
  std::vector<Integer> integers(5 * n), failed(n);
  Integer              length = -1, n_found = 0, info = 0;
  for (unsigned int call = 0; call < 2; ++call) // the first one asks how much memory it needs
    {
      dealii::syevx(&vectors,
                    &values,
                    &upper,
                    &size,
                    &lapack(0, 0),
                    &size,
                    &from,
                    &to,
                    &none,
                    &none,
                    &tolerance,
                    &n_found,
                    found.data(),
                    of_values.data(),
                    &size,
                    work.data(),
                    &length,
                    integers.data(),
                    failed.data(),
                    &info);
      if (call == 0)
        {
          length = static_cast<Integer>(work[0] + 1);
          work.resize(length);
        }
    }
  AssertThrow(info >= 0, dealii::ExcInternalError());

  Eigenpairs pairs;
  pairs.values.reinit(n_found);
  pairs.vectors.reinit(n, n_found);
  for (std::size_t k = 0; k < std::size_t(n_found); ++k)
    {
      pairs.values[k] = found[k];
      for (std::size_t i = 0; i < n; ++i)
        pairs.vectors(i, k) = of_values[k * n + i];
    }
  if (info > 0)
    {
      dealii::FullMatrix<double> rest(n, n_found);
      matrix.mmult(rest, pairs.vectors);
      for (std::size_t k = 0; k < std::size_t(n_found); ++k)
        for (std::size_t i = 0; i < n; ++i)
          rest(i, k) -= pairs.values[k] * pairs.vectors(i, k);
      AssertThrow(rest.linfty_norm() < 1e-10 * bound,
                  dealii::ExcMessage("LAPACK finds no eigenvectors of a symmetric matrix."));
    }
  return pairs;
}
} // namespace chaindrive
