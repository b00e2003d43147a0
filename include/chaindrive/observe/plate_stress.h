// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/solid_shell_stresses.h>
#include <chaindrive/element/stress.h>
#include <chaindrive/mesh/part.h>
#include <chaindrive/parameters/model.h>

#include <optional>
#include <vector>

namespace chaindrive::observe
{
/// Stresses [Pa] at the waist of a link's side plate: of the two plates the one at positive z, in
/// the middle between its holes. The link's axes are those of its part: x from its first joint to
/// the second, y square to it in the plate.
struct WaistStress
{
  double axial;        ///< along the link, mean over the section: the plate's pull over its area
  double in_plane;     ///< half of the stress along the link at the edge y < 0 less that at y > 0
  double out_of_plane; ///< half of the stress along the link in the outer face less the inner one
  double principal_1;  ///< larger in-plane principal stress in the middle of the plate
  double principal_2;  ///< the smaller one
};

/// What they follow from: linear in the strains.
struct WaistComponents
{
  double                        axial, in_plane, out_of_plane; ///< as there, Pa
  dealii::SymmetricTensor<2, 2> middle; ///< in-plane stress, mean of both faces, Pa
};

/// How many they are, and each by its number.
inline constexpr unsigned int n_waist_components = 6;

inline double &entry(WaistComponents &components, const unsigned int number)
{
  switch (number)
    {
    case 0:
      return components.axial;
    case 1:
      return components.in_plane;
    case 2:
      return components.out_of_plane;
    case 3:
      return components.middle[0][0];
    case 4:
      return components.middle[1][1];
    default:
      return components.middle[0][1];
    }
}

/// The stresses of @p components.
WaistStress stress_of(const WaistComponents &components);

/// Takes these stresses from nodal positions, as the mean of what lies to the left and to the right
/// of the middle: the mesh has vertices there. The pull is that of nodal forces and therefore
/// in balance with the load, to one percent, on any mesh if the edges are free; stresses of edges
/// and faces get better with the mesh. Plates that are membranes have the mean stress in both
/// faces, but for what element::membrane_bending leaves.
class PlateStress
{
public:
  /// @p part is an inner or outer link, @p nodes are its nodes, @p plates what its plates are of.
  PlateStress(const mesh::Part       &part,
              const mesh::Nodes      &nodes,
              const Material         &material,
              parameters::ElementType plates = parameters::ElementType::solid);

  /// The nodes of the part whose positions are needed.
  const std::vector<unsigned int> &nodes() const { return nodes_; }

  /// @p position of each of nodes() [m], in world axes or any others.
  WaistStress operator()(const std::vector<dealii::Tensor<1, 3>> &position) const
  {
    return stress_of(components(position));
  }

  WaistComponents components(const std::vector<dealii::Tensor<1, 3>> &position) const;

private:
  struct Cell
  {
    dealii::Tensor<1, 3>        weight; ///< its stress times this is its share in the mean
    std::array<unsigned int, 8> node;   ///< places in nodes_
    element::Gradients          gradients;

    std::optional<element::SolidShellCell> wall; ///< of a solid-shell or a membrane
  };
  struct Face
  {
    std::array<unsigned int, 4> node;
    element::FaceGradients      gradients;
  };

  /// Where @p node stands in nodes_, to which it is added.
  unsigned int place_of(unsigned int node);

  /// Mean in-plane stress of @p faces; the first axis lies along the link.
  dealii::SymmetricTensor<2, 2> mean(const std::vector<Face>                 &faces,
                                     const std::vector<dealii::Tensor<1, 3>> &position) const;

  Material                  material_;
  parameters::ElementType   plates_;
  std::vector<unsigned int> nodes_;
  std::vector<Cell>         section_;
  std::vector<Face>         lower_edge_, upper_edge_; ///< y < 0, y > 0
  std::vector<Face>         inner_face_, outer_face_;
};
} // namespace chaindrive::observe
