// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/elastic_part.h>
#include <chaindrive/mesh/nodes.h>
#include <chaindrive/reduction/symmetry.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <string>
#include <vector>

namespace chaindrive::reduction
{
/// Displacements or forces of all nodes of a part in its own axes, entry 3 node + component.
using Vector = dealii::Vector<double>;

/// The translations and the rotations about the centre of mass of the @p nodes of @p part, of unit
/// mass, 1/sqrt(kg): R^T M R = 1. A half part has those that leave its nodes in the middle plane.
std::vector<Vector> rigid_motions(const mesh::Part &part, const mesh::Nodes &nodes);

/// Small vibrations of a part that nothing holds, M u" + K u = f, with the stiffness of its element
/// blocks and the lumped masses of its nodes: those of an elastic body at rest. The nodes of a half
/// part in its middle plane have u_z = 0, and its motions are those of one half.
class FreePart
{
public:
  /// The arguments are read, not kept. @p elastic is that of @p part with @p nodes.
  FreePart(const mesh::Part &part, const mesh::Nodes &nodes, const element::ElasticPart &elastic);
  ~FreePart();

  unsigned int n_unknowns() const { return stiffness_.m(); }

  const std::string &name() const { return name_; }

  /// K, N/m. Rows and columns of unknowns in the middle plane of a half part are not left out; the
  /// vectors of this room are zero there.
  const dealii::SparseMatrix<double> &stiffness() const { return stiffness_; }

  /// M, kg.
  const dealii::DiagonalMatrix<Vector> &mass() const { return mass_; }

  /// Translations and rotations about the centre of mass, R^T M R = 1, 1/sqrt(kg).
  const std::vector<Vector> &rigid() const { return rigid_; }

  /// The reflections that leave K and M what they are.
  const Symmetry &symmetry() const { return symmetry_; }

  /// The part of @p u of the class @p c of symmetry(); all parts add up to it.
  Vector part_of_class(const Vector &u, unsigned int c) const;

  /// a^T M b.
  double mass_product(const Vector &a, const Vector &b) const;

  /// Whether the unknown @p i is held: across the middle plane of a half part.
  bool is_held(const unsigned int i) const { return held_[i] != 0; }

  /// u = G f [m], the displacement under the @p force [N] relative to the motion of a rigid body:
  /// K u = f - M R R^T f, R^T M u = 0 (inertia relief).
  Vector displacement(const Vector &force) const;

  /// The same for each of many forces, without refining the solutions, which costs several times as
  /// much as they do: they lose a few of their digits.
  std::vector<Vector> displacements(const std::vector<Vector> &forces) const;

private:
  /// Whether K and M commute with this reflection, as they do if it is a symmetry.
  bool commutes(const Symmetry &reflection) const;

  std::string                    name_;
  dealii::SparsityPattern        pattern_;
  dealii::SparseMatrix<double>   stiffness_;
  dealii::DiagonalMatrix<Vector> mass_;
  std::vector<char>              held_;
  std::vector<Vector>            rigid_;
  Symmetry                       symmetry_;

  /// As many unknowns as there are rigid motions, which these move by independent amounts: with
  /// them held the part is supported as a statically determinate body.
  std::vector<unsigned int> supports_;

  /// What is held of the supported part, and its stiffness, N/m.
  std::vector<unsigned int>    fixed_unknowns() const;
  dealii::SparseMatrix<double> supported_stiffness() const;

  /// Of the supported part, made when first needed.
  mutable std::unique_ptr<dealii::SparseDirectUMFPACK> inverse_;

  struct QuickInverse;
  mutable std::unique_ptr<QuickInverse> quick_; ///< the same for many forces
};
} // namespace chaindrive::reduction
