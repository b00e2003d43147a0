// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/substitution_kernels.h>
#include <chaindrive/utilities/simd.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace chaindrive::reduction
{
/// The factors of a symmetric, positive definite matrix, by KLU, and solutions for n_lanes right
/// sides at a time, without refinement.
class FactoredStiffness
{
public:
  /// @p matrix is read, not kept. An exception if it is singular. @p width numbers are computed at
  /// a time.
  explicit FactoredStiffness(const dealii::SparseMatrix<double> &matrix, int width = simd_width());

  /// The right sides @p f become the solutions.
  void solve(std::vector<dealii::Vector<double>> &f);

private:
  /// The columns of a factor, as TriangleColumns has them.
  struct Columns
  {
    std::vector<unsigned int> first{0}, row;
    std::vector<double>       entry;

    TriangleColumns view() const { return {first.data(), row.data(), entry.data()}; }
  };

  unsigned int                  n_;
  Columns                       lower_, upper_;
  std::vector<double>           inverse_;      ///< of the diagonal of the upper factor
  std::vector<int>              row_, column_; ///< of the matrix, of each row and column of factors
  dealii::AlignedVector<double> room_;
  const SubstitutionKernels    &kernels_;
};
} // namespace chaindrive::reduction
