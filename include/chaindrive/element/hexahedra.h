// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/element_block.h>
#include <chaindrive/element/kernels.h>
#include <chaindrive/material/material.h>
#include <chaindrive/mesh/nodes.h>
#include <chaindrive/parameters/model.h>

#include <functional>
#include <iterator>
#include <memory>
#include <vector>

namespace chaindrive::element
{
/// Which cells of a part are elements of a block, and of what kind.
struct Selection
{
  /// Components whose cells they are; if empty, all but the rigid zone of a sprocket.
  std::vector<dealii::types::material_id> components;

  /// Solid-shells and membranes have the hourglass stiffness of solid_shell_stiffness() in the
  /// place of that of their formulation, and its kernel is that of Formulation::enhanced.
  parameters::ElementType element_type = parameters::ElementType::solid;

  /// Direction through the thickness at the middle of a cell [m], from its inner to its outer face;
  /// of solid-shells and membranes.
  std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)> across;

  bool has(const dealii::types::material_id component) const;
};

/// Trilinear hexahedra, total Lagrangian, of St. Venant and Kirchhoff's material (doc/theory.md,
/// section 3). What the kernels need of a part, made once for all its copies: gradients, volumes
/// and hourglass stiffnesses of its elastic elements, lumped masses and positions of their nodes. A
/// sprocket's rigid zone is left out; nodes on its border are there.
///
/// Where all elements are prisms, as in every part swept along an axis, or even symmetric ones,
/// much of this vanishes. Each element has axes of its own for that, and its vertices may be
/// renumbered by a rotation: neither Green's strain nor an isotropic law sees in which axes the
/// gradients are.
class Hexahedra : public ElementBlock
{
public:
  /// @p nodes are those of @p part; @p hourglass_coefficient is that of Flanagan and Belytschko,
  /// used by Formulation::one_point. No shape beyond @p most_regular is looked for. Masses are
  /// those of all nodes of the part, whatever cells @p selection takes.
  Hexahedra(const mesh::Part  &part,
            const mesh::Nodes &nodes,
            const Material    &material,
            Formulation        formulation,
            double             hourglass_coefficient = 0.1,
            Shape              most_regular          = Shape::symmetric_prism,
            const Selection   &selection             = {});

  /// The same with the nodes made for the occasion.
  Hexahedra(const mesh::Part &part,
            const Material   &material,
            Formulation       formulation,
            double            hourglass_coefficient = 0.1,
            Shape             most_regular          = Shape::symmetric_prism,
            const Selection  &selection             = {})
      : Hexahedra(part,
                  mesh::Nodes(part),
                  material,
                  formulation,
                  hourglass_coefficient,
                  most_regular,
                  selection)
  {
  }

  unsigned int n_nodes() const { return static_cast<unsigned int>(mass.size()); }
  unsigned int n_elements() const override { return static_cast<unsigned int>(vertices.size()); }

  std::vector<unsigned int> nodes_of(const unsigned int e) const override
  {
    return {std::begin(vertices[e].node), std::end(vertices[e].node)};
  }

  void add_forces(const BatchState &batch) const override;

  /// Arguments of the force kernel but for the state.
  ForceArguments arguments() const;

  /// The stiffness matrix of small displacements, row 3 node + component, N/m.
  void assemble(dealii::SparsityPattern &pattern, dealii::SparseMatrix<double> &matrix) const
  {
    element::assemble({this}, n_nodes(), pattern, matrix);
  }

  /// Stiffness matrix of element @p e, row 3 a + i for component i of vertex a of Vertices, N/m.
  dealii::FullMatrix<double> element_stiffness(unsigned int e) const override;

  /// Largest natural frequency [rad/s] of the free part, see element::largest_frequency().
  double largest_frequency(const std::vector<double> &springs = {}) const
  {
    return element::largest_frequency({this}, mass, springs);
  }

  std::unique_ptr<const StressRecovery> make_stress_recovery(
      const mesh::Part &part, const mesh::Nodes &nodes, const Material &material) const override;

  std::size_t memory_consumption() const override;

  Formulation                       formulation;
  Shape                             shape;      ///< of every element
  double                            lambda, mu; ///< Lamé's constants, Pa
  std::vector<Vertices>             vertices;
  std::vector<double>               numbers;  ///< n_numbers() per geometry
  std::vector<dealii::Tensor<2, 3>> axes;     ///< of each element: the rows are its unit vectors
  std::vector<double>               mass;     ///< per node, kg
  std::vector<dealii::Point<3>>     position; ///< per node, in the part's frame, m

private:
  Selection      selection_;
  const Kernels &kernels_;
};
} // namespace chaindrive::element
