// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/stress.h>
#include <chaindrive/mesh/gauss_points.h>

#include <cmath>

#include <algorithm>

namespace chaindrive::element
{
using dealii::SymmetricTensor;
using dealii::Tensor;

Stress stress(const Tensor<2, 3> &F, const Material &material)
{
  return stress(
      F, 0.5 * (symmetrize(transpose(F) * F) - dealii::unit_symmetric_tensor<3>()), material);
}

Stress stress(const Tensor<2, 3> &F, const SymmetricTensor<2, 3> &strain, const Material &material)
{
  Stress s;
  s.strain = strain;
  s.piola  = material.lambda() * trace(strain) * dealii::unit_symmetric_tensor<3>() +
            2. * material.mu() * strain;
  s.cauchy = symmetrize(F * Tensor<2, 3>(s.piola) * transpose(F)) / determinant(F);
  return s;
}

double von_mises(const SymmetricTensor<2, 3> &stress)
{
  const SymmetricTensor<2, 3> s = deviator(stress);
  return std::sqrt(1.5 * (s * s));
}

Gradients mean_gradients(const mesh::Corners &corners)
{
  Gradients gradients;
  double    volume = 0.;
  for (const mesh::GaussPoint &point : mesh::gauss_points(corners))
    {
      for (unsigned int a = 0; a < 8; ++a)
        gradients[a] += point.volume * point.gradient[a];
      volume += point.volume;
    }
  for (Tensor<1, 3> &gradient : gradients)
    gradient /= volume;
  return gradients;
}

Tensor<2, 3> deformation_gradient(const Gradients                   &gradients,
                                  const std::array<Tensor<1, 3>, 8> &position)
{
  Tensor<2, 3> F;
  for (unsigned int a = 0; a < 8; ++a)
    F += outer_product(position[a], gradients[a]);
  return F;
}

CellStresses::CellStresses(const mesh::Part                              &part,
                           const mesh::Nodes                             &nodes,
                           const Material                                &material,
                           const std::vector<dealii::types::material_id> &components)
    : n_cells_(part.mesh->n_active_cells()), material_(material)
{
  unsigned int n_elastic = 0;
  for (const auto &cell : part.mesh->active_cell_iterators())
    if (cell->material_id() != mesh::hub_zone)
      {
        const unsigned int elastic = n_elastic++;
        if (!components.empty() &&
            std::find(components.begin(), components.end(), cell->material_id()) ==
                components.end())
          continue;
        cell_.push_back(cell->active_cell_index());
        nodes_.push_back(nodes.cells[elastic]);
        gradients_.push_back(mean_gradients(mesh::corners_of(cell)));
      }
}

void CellStresses::recover(const std::vector<Tensor<1, 3>> &position,
                           std::vector<Stress>             &stresses) const
{
  for (unsigned int e = 0; e < cell_.size(); ++e)
    {
      std::array<Tensor<1, 3>, 8> corners;
      for (unsigned int a = 0; a < 8; ++a)
        corners[a] = position[nodes_[e][a]];
      stresses[cell_[e]] = stress(deformation_gradient(gradients_[e], corners), material_);
    }
}

FaceGradients face_gradients(const std::array<dealii::Point<3>, 4> &corners,
                             const Tensor<1, 3>                    &along,
                             const Tensor<1, 3>                    &across)
{
  // of the bilinear shape functions in the middle of the unit square
  constexpr double derivative[2][4] = {{-0.5, 0.5, -0.5, 0.5}, {-0.5, -0.5, 0.5, 0.5}};
  Tensor<1, 3>     tangent[2];
  for (unsigned int d = 0; d < 2; ++d)
    for (unsigned int a = 0; a < 4; ++a)
      tangent[d] += derivative[d][a] * corners[a];
  Tensor<1, 3> normal = cross_product_3d(tangent[0], tangent[1]);
  normal /= normal.norm();

  Tensor<1, 3> axis[2];
  axis[0] = along - (along * normal) * normal;
  axis[0] /= axis[0].norm();
  axis[1] = cross_product_3d(normal, axis[0]);
  if (axis[1] * across < 0.)
    axis[1] *= -1.;

  Tensor<2, 2> jacobian; // row: axis, column: coordinate of the unit square
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int d = 0; d < 2; ++d)
      jacobian[i][d] = axis[i] * tangent[d];
  const Tensor<2, 2> inverse = invert(jacobian);

  FaceGradients gradients;
  for (unsigned int a = 0; a < 4; ++a)
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int d = 0; d < 2; ++d)
        gradients[a][i] += derivative[d][a] * inverse[d][i];
  return gradients;
}

SymmetricTensor<2, 2> face_stress(const FaceGradients               &gradients,
                                  const std::array<Tensor<1, 3>, 4> &position,
                                  const Material                    &material)
{
  Tensor<1, 3> line[2]; // what the axes have become
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int a = 0; a < 4; ++a)
      line[i] += gradients[a][i] * position[a];

  const SymmetricTensor<2, 2> one = dealii::unit_symmetric_tensor<2>();
  SymmetricTensor<2, 2>       strain;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      strain[i][j] = 0.5 * (line[i] * line[j] - one[i][j]);
  const double nu = material.poissons_ratio;
  return material.plane_modulus() * ((1. - nu) * strain + nu * trace(strain) * one);
}
} // namespace chaindrive::element
