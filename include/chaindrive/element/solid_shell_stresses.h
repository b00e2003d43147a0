// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/hexahedra.h>
#include <chaindrive/element/stress.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace chaindrive::element
{
/// Stress in one cell of a solid-shell or a membrane.
class SolidShellCell
{
public:
  /// @p across leads through the thickness, to its outer face.
  SolidShellCell(const mesh::Corners        &corners,
                 const dealii::Tensor<1, 3> &across,
                 const Material             &material,
                 parameters::ElementType     element_type);

  /// Mean over the cell, of the strain E + D q of doc/theory.md, section 3. The volume times half
  /// of the product of both is the strain energy of the force kernel. @p position of the vertices,
  /// m.
  Stress mean(const std::array<dealii::Tensor<1, 3>, 8> &position) const;

  /// In the middle of both faces, where nothing acts. Those of a membrane, which has stress from
  /// the strain of its middle surface only, differ by membrane_bending of what those of a
  /// solid-shell do.
  FaceStresses faces(const std::array<dealii::Tensor<1, 3>, 8> &position) const;

private:
  struct Face
  {
    std::array<unsigned int, 4>         vertex;
    std::array<dealii::Tensor<1, 3>, 2> axes; ///< in the face
    FaceGradients                       gradients;
  };

  dealii::SymmetricTensor<2, 3>
  stress_in(const Face &face, const std::array<dealii::Tensor<1, 3>, 8> &position) const;

  mesh::Corners              corners_;
  Material                   material_;
  parameters::ElementType    element_type_;
  Gradients                  gradients_;
  dealii::FullMatrix<double> strain_; ///< SolidShellStiffness::mean_strain
  Face                       inner_, outer_;
};

/// Strain and stress of every cell of a block of solid-shells or membranes.
class SolidShellStresses : public StressRecovery
{
public:
  /// Of the cells of @p selection; @p nodes are those of @p part.
  SolidShellStresses(const mesh::Part  &part,
                     const mesh::Nodes &nodes,
                     const Material    &material,
                     const Selection   &selection);

  unsigned int n_cells() const override { return n_cells_; }

  void recover(const std::vector<dealii::Tensor<1, 3>> &position,
               std::vector<Stress>                     &stresses) const override;

  bool has_faces() const override { return true; }

  void recover_faces(const std::vector<dealii::Tensor<1, 3>> &position,
                     std::vector<FaceStresses>               &stresses) const override;

private:
  std::array<dealii::Tensor<1, 3>, 8>
  corners_of(unsigned int e, const std::vector<dealii::Tensor<1, 3>> &position) const;

  unsigned int                             n_cells_;
  std::vector<SolidShellCell>              walls_;
  std::vector<std::array<unsigned int, 8>> nodes_; ///< per cell of a wall
  std::vector<unsigned int>                cell_;  ///< its number in the mesh
};
} // namespace chaindrive::element
