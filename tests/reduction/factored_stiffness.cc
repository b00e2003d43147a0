// SPDX-License-Identifier: LGPL-2.1-or-later
// Solutions by the factors of a stiffness, for more right sides than fit into the lanes at once and
// by kernels of all widths: a random network of springs on a plane, some of whose points are held,
// is loaded by the forces that known displacements need, and gives these. A network that nothing
// holds is refused.
#include <chaindrive/reduction/factored_stiffness.h>
#include <chaindrive/utilities/simd.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

using namespace chaindrive;

namespace
{
constexpr unsigned int n_side = 23, n = n_side * n_side;

/// Springs of random stiffness between neighbours, and from every @p held one of the points to the
/// ground, where its row is that of the identity as well.
dealii::SparseMatrix<double> network(dealii::SparsityPattern &pattern, const unsigned int held)
{
  dealii::DynamicSparsityPattern entries(n, n);
  const auto                     for_springs = [](const auto &spring) {
    for (unsigned int i = 0; i < n; ++i)
      {
        if (i % n_side + 1 < n_side)
          spring(i, i + 1);
        if (i + n_side < n)
          spring(i, i + n_side);
      }
  };
  for (unsigned int i = 0; i < n; ++i)
    entries.add(i, i);
  for_springs([&](const unsigned int i, const unsigned int j) {
    entries.add(i, j);
    entries.add(j, i);
  });
  pattern.copy_from(entries);
  dealii::SparseMatrix<double>           matrix(pattern);
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> uniform(1., 100.);
  for_springs([&](const unsigned int i, const unsigned int j) {
    // whole numbers: sums of rows are exact
    const double stiffness = std::floor(uniform(random));
    const bool   free[]    = {held == 0 || i % held != 0, held == 0 || j % held != 0};
    matrix.add(i, i, free[0] ? stiffness : 0.);
    matrix.add(j, j, free[1] ? stiffness : 0.);
    if (free[0] && free[1])
      {
        matrix.add(i, j, -stiffness);
        matrix.add(j, i, -stiffness);
      }
  });
  for (unsigned int i = 0; held != 0 && i < n; i += held)
    matrix.set(i, i, 1.);
  return matrix;
}
} // namespace

int main()
{
  dealii::SparsityPattern            pattern, of_loose;
  const dealii::SparseMatrix<double> matrix = network(pattern, 29);

  std::mt19937                           random(5);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  std::vector<dealii::Vector<double>>    known(19, dealii::Vector<double>(n)), forces = known;
  for (std::size_t f = 0; f < known.size(); ++f)
    {
      for (double &u : known[f])
        u = uniform(random);
      matrix.vmult(forces[f], known[f]);
    }
  for (const int width : {1, 2, 4, 8})
    {
      if (!has_simd_width(width))
        continue;
      reduction::FactoredStiffness        factored(matrix, width);
      std::vector<dealii::Vector<double>> u = forces;
      factored.solve(u);
      double worst = 0.;
      for (std::size_t f = 0; f < u.size(); ++f)
        {
          u[f] -= known[f];
          worst = std::max(worst, u[f].linfty_norm());
        }
      if (worst > 1e-12)
        std::cout << "width " << width << ": displacements differ by " << worst << std::endl;
    }
  std::cout << "displacements of " << known.size() << " loads found" << std::endl;

  const dealii::SparseMatrix<double> loose = network(of_loose, 0);
  try
    {
      reduction::FactoredStiffness factored(loose);
      std::cout << "what nothing holds has factors" << std::endl;
    }
  catch (const std::exception &)
    {
      std::cout << "what nothing holds is refused" << std::endl;
    }
}
