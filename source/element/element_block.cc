// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/element_block.h>
#include <chaindrive/element/selective_masses.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <cmath>

namespace chaindrive::element
{
namespace
{
/// Rows of the part's matrix for those of an element's.
std::vector<dealii::types::global_dof_index> rows_of(const ElementBlock &block,
                                                     const unsigned int  e)
{
  std::vector<dealii::types::global_dof_index> rows;
  const unsigned int                           n = block.unknowns_per_node();
  for (const unsigned int node : block.nodes_of(e))
    for (unsigned int i = 0; i < n; ++i)
      rows.push_back(n * node + i);
  return rows;
}
} // namespace

void assemble(const std::vector<const ElementBlock *> &blocks,
              const unsigned int                       n_nodes,
              dealii::SparsityPattern                 &pattern,
              dealii::SparseMatrix<double>            &matrix)
{
  dealii::DynamicSparsityPattern dynamic(3 * n_nodes);
  for (const ElementBlock *block : blocks)
    for (unsigned int e = 0; e < block->n_elements(); ++e)
      {
        const auto rows = rows_of(*block, e);
        for (const auto row : rows)
          dynamic.add_entries(row, rows.begin(), rows.end());
      }
  pattern.copy_from(dynamic);
  matrix.reinit(pattern);
  for (const ElementBlock *block : blocks)
    for (unsigned int e = 0; e < block->n_elements(); ++e)
      matrix.add(rows_of(*block, e), block->element_stiffness(e));
}

double largest_frequency(const std::vector<const ElementBlock *> &blocks,
                         const SelectiveMasses                   &mass,
                         const std::vector<double>               &springs)
{
  dealii::SparsityPattern      pattern;
  dealii::SparseMatrix<double> matrix;
  assemble(blocks, mass.n_nodes(), pattern, matrix);

  const unsigned int n = 3 * mass.n_nodes();
  for (unsigned int i = 0; i < n && !springs.empty(); ++i)
    matrix.diag_element(i) += springs[i / 3];

  dealii::Vector<double> scaled(n);
  return std::sqrt(largest_eigenvalue(n, [&](auto &product, const auto &x) { // L^-1 K L^-T
    scaled = x;
    mass.solve_upper(scaled);
    matrix.vmult(product, scaled);
    mass.solve_lower(product);
  }));
}

double largest_frequency(const std::vector<const ElementBlock *> &blocks,
                         const std::vector<double>               &mass,
                         const std::vector<double>               &springs)
{
  return largest_frequency(blocks, SelectiveMasses(mass), springs);
}
} // namespace chaindrive::element
