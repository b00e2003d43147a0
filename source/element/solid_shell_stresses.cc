// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/solid_shell_stiffness.h>
#include <chaindrive/element/solid_shell_stresses.h>

namespace chaindrive::element
{
using dealii::SymmetricTensor;
using dealii::Tensor;

SolidShellCell::SolidShellCell(const mesh::Corners          &corners,
                               const Tensor<1, 3>           &across,
                               const Material               &material,
                               const parameters::ElementType element_type)
    : corners_(corners)
    , material_(material)
    , element_type_(element_type)
    , gradients_(mean_gradients(corners))
{
  const unsigned int axis = nearest_axis(corners, across);
  strain_                 = stiffness_of_type(corners, axis, material, element_type).mean_strain;

  std::array<Face, 2> faces; // at the low and at the high end of the axis
  Tensor<1, 3>        upwards;
  for (const unsigned int side : {0, 1})
    {
      Face        &face = faces[side];
      unsigned int n    = 0;
      for (unsigned int a = 0; a < 8; ++a)
        if ((a >> axis & 1) == side)
          {
            face.vertex[n++] = a;
            upwards += (side == 1 ? 0.25 : -0.25) * corners[a];
          }
      std::array<dealii::Point<3>, 4> points;
      for (unsigned int v = 0; v < 4; ++v)
        points[v] = corners[face.vertex[v]];
      const Tensor<1, 3> first  = points[1] + (points[3] - points[2]) - points[0],
                         second = points[2] + (points[3] - points[1]) - points[0];
      face.axes[0]              = first / first.norm();
      face.axes[1]              = second - (second * face.axes[0]) * face.axes[0];
      face.axes[1] /= face.axes[1].norm();
      face.gradients = face_gradients(points, face.axes[0], face.axes[1]);
    }
  const bool is_outer = upwards * across > 0.;
  inner_              = faces[is_outer ? 0 : 1];
  outer_              = faces[is_outer ? 1 : 0];
}

Stress SolidShellCell::mean(const std::array<Tensor<1, 3>, 8> &position) const
{
  // D q depends on what the positions have beside the mean gradient, F^T (x - F X): that of the
  // hourglass amplitudes, up to a constant, which strains do not see
  const Tensor<2, 3>     F      = deformation_gradient(gradients_, position);
  SymmetricTensor<2, 3>  strain = stress(F, material_).strain;
  std::array<double, 24> u;
  for (unsigned int a = 0; a < 8; ++a)
    {
      const Tensor<1, 3> pulled = transpose(F) * (position[a] - F * Tensor<1, 3>(corners_[a]));
      for (unsigned int i = 0; i < 3; ++i)
        u[3 * a + i] = pulled[i];
    }
  for (unsigned int r = 0; r < n_strains; ++r)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < 24; ++i)
        sum += strain_(r, i) * u[i];
      strain[strain_pair[r][0]][strain_pair[r][1]] += (r < 3 ? 1. : 0.5) * sum;
    }
  return stress(F, strain, material_);
}

SymmetricTensor<2, 3> SolidShellCell::stress_in(const Face                        &face,
                                                const std::array<Tensor<1, 3>, 8> &position) const
{
  std::array<Tensor<1, 3>, 4> corners;
  for (unsigned int v = 0; v < 4; ++v)
    corners[v] = position[face.vertex[v]];
  const SymmetricTensor<2, 2> s = face_stress(face.gradients, corners, material_);
  Tensor<2, 3>                sum;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      sum += s[i][j] * outer_product(face.axes[i], face.axes[j]);
  return symmetrize(sum);
}

FaceStresses SolidShellCell::faces(const std::array<Tensor<1, 3>, 8> &position) const
{
  FaceStresses found{stress_in(inner_, position), stress_in(outer_, position)};
  if (element_type_ == parameters::ElementType::membrane)
    {
      const SymmetricTensor<2, 3> middle  = 0.5 * (found.inner + found.outer),
                                  bending = 0.5 * membrane_bending * (found.outer - found.inner);
      found                               = {middle - bending, middle + bending};
    }
  return found;
}

SolidShellStresses::SolidShellStresses(const mesh::Part  &part,
                                       const mesh::Nodes &nodes,
                                       const Material    &material,
                                       const Selection   &selection)
    : n_cells_(part.mesh->n_active_cells())
{
  unsigned int n_elastic = 0;
  for (const auto &cell : part.mesh->active_cell_iterators())
    if (cell->material_id() != mesh::hub_zone)
      {
        const unsigned int elastic = n_elastic++;
        if (!selection.has(cell->material_id()))
          continue;
        cell_.push_back(cell->active_cell_index());
        nodes_.push_back(nodes.cells[elastic]);
        walls_.emplace_back(mesh::corners_of(cell),
                            selection.across(cell->center()),
                            material,
                            selection.element_type);
      }
}

std::array<Tensor<1, 3>, 8>
SolidShellStresses::corners_of(const unsigned int               e,
                               const std::vector<Tensor<1, 3>> &position) const
{
  std::array<Tensor<1, 3>, 8> corners;
  for (unsigned int a = 0; a < 8; ++a)
    corners[a] = position[nodes_[e][a]];
  return corners;
}

void SolidShellStresses::recover(const std::vector<Tensor<1, 3>> &position,
                                 std::vector<Stress>             &stresses) const
{
  for (unsigned int e = 0; e < walls_.size(); ++e)
    stresses[cell_[e]] = walls_[e].mean(corners_of(e, position));
}

void SolidShellStresses::recover_faces(const std::vector<Tensor<1, 3>> &position,
                                       std::vector<FaceStresses>       &stresses) const
{
  for (unsigned int e = 0; e < walls_.size(); ++e)
    stresses[cell_[e]] = walls_[e].faces(corners_of(e, position));
}
} // namespace chaindrive::element
