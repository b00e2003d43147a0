// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/stress.h>
#include <chaindrive/utilities/pack.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>

#include <memory>
#include <vector>

namespace chaindrive::element
{
/// One batch as the forces of elements see it: bodies side by side, [node][component][lane].
struct BatchState
{
  const double *position;         ///< world axes, m
  double       *force;            ///< to which internal forces are added, N
  double       *strain_energy;    ///< [lane], to which is added, J
  double       *hourglass_energy; ///< [lane], to which is added, J
  const double *next   = nullptr; ///< what is read afterwards, fetched into the cache meanwhile
  unsigned int  n_next = 0;       ///< numbers there
};

/// Sums over the nodes of one batch, [lane] each; vectors are [component][lane].
struct BatchSums
{
  using Vector = double[3 * n_lanes];

  double strain[n_lanes], hourglass[n_lanes], kinetic[n_lanes]; ///< energies, J
  Vector first_moment, momentum;                                ///< m x, kg m; m v, kg m/s

  /// One of the vectors of one body.
  static dealii::Tensor<1, 3> of_lane(const Vector &sums, const unsigned int lane)
  {
    dealii::Tensor<1, 3> v;
    for (unsigned int d = 0; d < 3; ++d)
      v[d] = sums[d * n_lanes + lane];
    return v;
  }
};

/// The elements of one kind in a part, for all bodies that are copies of it. A part is a list of
/// blocks (ElasticPart); a kind of element is one class derived from this and a line in
/// ElasticPart's constructor. Calls are virtual once per block and batch; what runs over elements
/// and lanes is a kernel of plain pointers behind add_forces().
///
/// Lumped masses are those of the nodes (mesh::Nodes), which contacts and rims need without
/// elements. Elements whose nodes turn have more unknowns than the three that BodyBatches has room
/// for, and their rotations are no vectors to be added up: such a block would ask BodyBatches for a
/// field of its own, beside position and velocity, and bring the kernel that moves it.
class ElementBlock
{
public:
  virtual ~ElementBlock() = default;

  virtual unsigned int n_elements() const = 0;

  /// The nodes of element @p e, in the order of its stiffness matrix.
  virtual std::vector<unsigned int> nodes_of(unsigned int e) const = 0;

  /// Rows of the stiffness matrix for each node: three displacements.
  virtual unsigned int unknowns_per_node() const { return 3; }

  /// Adds the internal forces of one batch, and their energies.
  virtual void add_forces(const BatchState &batch) const = 0;

  /// Stiffness matrix of element @p e for small displacements, row unknowns_per_node() a + i for
  /// component i of its node a, axes of the part, N/m.
  virtual dealii::FullMatrix<double> element_stiffness(unsigned int e) const = 0;

  /// What finds strain and stress in the cells of this block, made when results ask for it. The
  /// arguments are those from which the block was made.
  virtual std::unique_ptr<const StressRecovery> make_stress_recovery(
      const mesh::Part &part, const mesh::Nodes &nodes, const Material &material) const = 0;

  virtual std::size_t memory_consumption() const = 0;
};

/// Stiffness matrix of small displacements of the blocks of a part with @p n_nodes nodes, row 3
/// node + component, N/m.
void assemble(const std::vector<const ElementBlock *> &blocks,
              unsigned int                             n_nodes,
              dealii::SparsityPattern                 &pattern,
              dealii::SparseMatrix<double>            &matrix);

class SelectiveMasses;

/// Largest natural frequency [rad/s] of the free part with the masses @p mass at small amplitudes,
/// from above, by largest_eigenvalue(). @p springs [N/m], if not empty, hold each node in all
/// directions.
double largest_frequency(const std::vector<const ElementBlock *> &blocks,
                         const SelectiveMasses                   &mass,
                         const std::vector<double>               &springs);

/// The same with @p mass of each node, kg.
double largest_frequency(const std::vector<const ElementBlock *> &blocks,
                         const std::vector<double>               &mass,
                         const std::vector<double>               &springs);
} // namespace chaindrive::element
