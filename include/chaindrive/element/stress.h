// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>
#include <chaindrive/mesh/nodes.h>
#include <chaindrive/mesh/quality.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <vector>

namespace chaindrive::element
{
/// Strain and stress at one point of a body of the material of St. Venant and Kirchhoff
/// (Belytschko, Liu, Moran and Elkhodary 2014, ch. 3 and 5).
///
/// Body axes are those of the reference mesh and turn with the material: Green's strain and the
/// second Piola-Kirchhoff stress, which belong together, do not see where and how a copy has
/// turned. At the strains of a chain the second differs from Cauchy's stress in turned axes by
/// about a thousandth.
struct Stress
{
  dealii::SymmetricTensor<2, 3> strain; ///< Green's, body axes
  dealii::SymmetricTensor<2, 3> piola;  ///< second Piola-Kirchhoff, body axes, Pa
  dealii::SymmetricTensor<2, 3> cauchy; ///< force per present area, world axes, Pa
};

/// From the deformation gradient @p F: reference axes to world axes, any rotation in it.
Stress stress(const dealii::Tensor<2, 3> &F, const Material &material);

/// The same where an element has a Green's strain @p strain of its own.
Stress stress(const dealii::Tensor<2, 3>          &F,
              const dealii::SymmetricTensor<2, 3> &strain,
              const Material                      &material);

/// Von Mises' equivalent of @p stress, sqrt(3/2 s:s) with its deviator s, in its unit.
double von_mises(const dealii::SymmetricTensor<2, 3> &stress);

/// Gradients of the shape functions of a trilinear hexahedron, mean over its volume, 1/m: those
/// from which formulations "one point" and "enhanced" take their stress.
using Gradients = std::array<dealii::Tensor<1, 3>, 8>;
Gradients mean_gradients(const mesh::Corners &corners);

/// Mean deformation gradient of a hexahedron whose vertices are at @p position now, m.
dealii::Tensor<2, 3> deformation_gradient(const Gradients                           &gradients,
                                          const std::array<dealii::Tensor<1, 3>, 8> &position);

/// Second Piola-Kirchhoff stresses at both faces of a wall, plane stress, body axes, Pa.
struct FaceStresses
{
  dealii::SymmetricTensor<2, 3> inner, outer;
};

/// Finds strain and stress in cells of a part from the positions of its nodes.
class StressRecovery
{
public:
  virtual ~StressRecovery() = default;

  /// Active cells of the part's mesh.
  virtual unsigned int n_cells() const = 0;

  /// Sets the entries of those cells in @p stresses, one per active cell of the mesh, that this
  /// knows of. @p position of each node of one body [m], in world axes or any others.
  virtual void recover(const std::vector<dealii::Tensor<1, 3>> &position,
                       std::vector<Stress>                     &stresses) const = 0;

  /// Whether its cells are those of walls with faces of their own.
  virtual bool has_faces() const { return false; }

  /// Sets the stresses at the faces of those cells in @p stresses, one per active cell.
  virtual void recover_faces(const std::vector<dealii::Tensor<1, 3>> & /*position*/,
                             std::vector<FaceStresses> & /*stresses*/) const
  {
  }

  /// Of all cells; zero where this knows of none, as in a rigid zone.
  std::vector<Stress> operator()(const std::vector<dealii::Tensor<1, 3>> &position) const
  {
    std::vector<Stress> stresses(n_cells());
    recover(position, stresses);
    return stresses;
  }
};

/// Strain and stress of every solid element of a part, from the mean gradient over the cell. What
/// bends through one layer of cells has its stress in their middle surface; see face_stress() for
/// its sides, and SolidShellStresses for solid-shells.
class CellStresses : public StressRecovery
{
public:
  /// Of the cells of @p components, or of all elastic ones if there is none; @p nodes are those of
  /// @p part.
  CellStresses(const mesh::Part                              &part,
               const mesh::Nodes                             &nodes,
               const Material                                &material,
               const std::vector<dealii::types::material_id> &components = {});

  unsigned int n_cells() const override { return n_cells_; }

  void recover(const std::vector<dealii::Tensor<1, 3>> &position,
               std::vector<Stress>                     &stresses) const override;

private:
  unsigned int                             n_cells_;
  Material                                 material_;
  std::vector<std::array<unsigned int, 8>> nodes_;     ///< per elastic cell
  std::vector<unsigned int>                cell_;      ///< its number in the mesh
  std::vector<Gradients>                   gradients_; ///< 1/m
};

/// Gradients of the shape functions of a face in its middle, 1/m, with @p corners [m] in deal.II's
/// order. The first axis is @p along, laid into the face; the second lies square to it in the face,
/// on the side of @p across.
using FaceGradients = std::array<dealii::Tensor<1, 2>, 4>;
FaceGradients face_gradients(const std::array<dealii::Point<3>, 4> &corners,
                             const dealii::Tensor<1, 3>            &along,
                             const dealii::Tensor<1, 3>            &across);

/// Second Piola-Kirchhoff stress [Pa] in the middle of a face on which nothing acts: plane stress,
/// from the face's own strain. Axes are those of @p gradients, @p position are its corners now [m].
dealii::SymmetricTensor<2, 2> face_stress(const FaceGradients                       &gradients,
                                          const std::array<dealii::Tensor<1, 3>, 4> &position,
                                          const Material                            &material);
} // namespace chaindrive::element
