// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/kernels.h>
#include <chaindrive/mesh/nodes.h>
#include <chaindrive/parameters/model.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>

#include <vector>

namespace chaindrive::element
{
/// What the kernels need of a part, made once for all its copies: gradients, volumes and hourglass
/// stiffnesses of its elastic elements, lumped masses and positions of their nodes. A sprocket's
/// rigid zone is left out; nodes on its border are there.
class Reference
{
public:
  /// @p nodes are those of @p part; @p hourglass_coefficient is that of Flanagan and Belytschko,
  /// used by Formulation::one_point.
  Reference(const mesh::Part           &part,
            const mesh::Nodes          &nodes,
            const parameters::Material &material,
            Formulation                 formulation,
            double                      hourglass_coefficient = 0.1);

  /// The same with the nodes made for the occasion.
  Reference(const mesh::Part &part, const parameters::Material &material, Formulation formulation)
      : Reference(part, mesh::Nodes(part), material, formulation)
  {
  }

  unsigned int n_nodes() const { return static_cast<unsigned int>(mass.size()); }
  unsigned int n_elements() const { return static_cast<unsigned int>(elements.size()); }

  /// Arguments of the force kernel but for the state.
  ForceArguments arguments() const;

  /// The stiffness matrix of small displacements, row 3 node + component, N/m.
  void assemble(dealii::SparsityPattern &pattern, dealii::SparseMatrix<double> &matrix) const;

  /// Stiffness matrix of element @p e, row 3 a + i for component i of vertex a, N/m.
  dealii::FullMatrix<double> element_stiffness(unsigned int e) const;

  /// Largest natural frequency [rad/s] of the free part at small amplitudes: the largest Ritz value
  /// of up to 400 conjugate gradient steps, less than one in a thousand too small.
  double largest_frequency() const;

  std::size_t memory_consumption() const;

  Formulation                     formulation;
  double                          lambda, mu; ///< Lamé's constants, Pa
  std::vector<Hexahedron>         elements;
  std::vector<HourglassStiffness> hourglass;
  std::vector<double>             hourglass_stiffness;
  std::vector<PointGradients>     points;
  std::vector<double>             mass;     ///< per node, kg
  std::vector<dealii::Point<3>>   position; ///< per node, in the part's frame, m
};
} // namespace chaindrive::element
