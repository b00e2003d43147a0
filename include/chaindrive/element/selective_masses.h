// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/element_block.h>
#include <chaindrive/element/kernels.h>
#include <chaindrive/mesh/nodes.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace chaindrive::element
{
/// The masses of the nodes of a part, with more of it in the columns of nodes through a wall:
///
///   M' = M + factor sum over layers of m_l [[1, -1], [-1, 1]]
///
/// for each direction, m_l being what a layer's share of the column weighs. A column that moves as
/// a whole weighs what it did; what moves against each other weighs more, which slows the vibration
/// through the thickness down: that of one layer of stiffness k from 2 sqrt(k / m_l) to
/// 2 sqrt(k / (m_l (1 + 4 factor))). Linear momentum is that of M. After Olovsson, Simonsson,
/// Unosson (2005), with the edges of a column in the place of all edges of an element.
class SelectiveMasses
{
public:
  /// @p mass per node, kg, without columns.
  explicit SelectiveMasses(std::vector<double> mass);

  /// @p columns of nodes, in their order through the thickness, of a part with @p nodes. No node is
  /// in two of them.
  SelectiveMasses(const mesh::Nodes                            &nodes,
                  const std::vector<std::vector<unsigned int>> &columns,
                  double                                        factor);

  /// Whether M' is M.
  bool empty() const { return node_.empty(); }

  unsigned int n_nodes() const { return static_cast<unsigned int>(mass_.size()); }

  /// Makes M M'^-1 f of the forces f of one batch, with which nodes of the masses M are accelerated
  /// as those of M' by f, and adds to its kinetic energy what M' has more than M; see
  /// SelectiveMassArguments.
  void apply(const Kernels &kernels,
             double         kick,
             double         drag,
             const double  *velocity,
             double        *force,
             double        *kinetic_energy) const;

  /// x := L^-1 x or L^-T x with M' = L L^T, entry 3 node + component; SI units.
  void solve_lower(dealii::Vector<double> &x) const;
  void solve_upper(dealii::Vector<double> &x) const;

  /// What M' has more of than M: a . (M' - M) a.
  double added(const dealii::Vector<double> &a) const;

  std::size_t memory_consumption() const;

private:
  std::vector<double>       mass_;  ///< per node, kg
  std::vector<double>       scale_; ///< per node, 1 over the diagonal of L, 1/sqrt(kg)
  std::vector<unsigned int> begin_; ///< per column, in what follows, and the end
  std::vector<unsigned int> node_;  ///< column after column
  std::vector<double>       added_, lower_, pivot_; ///< as SelectiveMassArguments says
};
} // namespace chaindrive::element
