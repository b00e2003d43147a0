// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cstddef>
#include <functional>
#include <limits>

namespace chaindrive
{
/// Makes the product of a symmetric matrix and the second vector the first.
using Product = std::function<void(dealii::Vector<double> &, const dealii::Vector<double> &)>;

/// The largest eigenvalue of a symmetric matrix without negative ones, @p n numbers wide: Lanczos'
/// method (Saad, Numerical Methods for Large Eigenvalue Problems, 6.6), until the residual is less
/// than a millionth of the value, and above it by this residual.
double largest_eigenvalue(std::size_t n, const Product &product);

/// Eigenvalues, ascending, and orthonormal eigenvectors, the columns of a matrix.
struct Eigenpairs
{
  dealii::Vector<double>     values;
  dealii::FullMatrix<double> vectors;
};

/// All of the symmetric @p matrix, by LAPACK, or those with values up to @p up_to.
Eigenpairs eigenpairs(const dealii::FullMatrix<double> &matrix,
                      double up_to = std::numeric_limits<double>::infinity());
} // namespace chaindrive
