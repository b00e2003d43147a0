// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/reference.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <cmath>

namespace chaindrive::element
{
double Reference::largest_frequency(const std::vector<double> &springs) const
{
  dealii::SparsityPattern      pattern;
  dealii::SparseMatrix<double> matrix;
  assemble(pattern, matrix);

  const unsigned int n = 3 * n_nodes();
  for (unsigned int i = 0; i < n && !springs.empty(); ++i)
    matrix.diag_element(i) += springs[i / 3];

  dealii::Vector<double> scale(n), scaled(n);
  for (unsigned int i = 0; i < n; ++i)
    scale[i] = 1. / std::sqrt(mass[i / 3]);
  return std::sqrt(largest_eigenvalue(n, [&](auto &product, const auto &x) { // M^-1/2 K M^-1/2
    scaled = x;
    scaled.scale(scale);
    matrix.vmult(product, scaled);
    product.scale(scale);
  }));
}
} // namespace chaindrive::element
