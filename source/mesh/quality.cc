// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/quality.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::mesh
{
using dealii::Tensor;

Corners corners_of(const dealii::Triangulation<3>::active_cell_iterator &cell)
{
  Corners corners;
  for (const unsigned int v : cell->vertex_indices())
    corners[v] = cell->vertex(v);
  return corners;
}

double scaled_jacobian(const Corners &corners)
{
  double worst = std::numeric_limits<double>::max();
  for (unsigned int v = 0; v < 8; ++v)
    {
      std::array<Tensor<1, 3>, 3> e;
      for (unsigned int d = 0; d < 3; ++d)
        {
          // the other end of the edge along direction d
          e[d] = corners[v ^ (1u << d)] - corners[v];
          e[d] /= (v >> d) & 1u ? -e[d].norm() : e[d].norm();
        }
      worst = std::min(worst, dealii::cross_product_3d(e[0], e[1]) * e[2]);
    }
  return worst;
}

double largest_frequency(const Corners              &corners,
                         const parameters::Material &material,
                         const double                density)
{
  const double E = material.youngs_modulus, nu = material.poissons_ratio;
  const double lambda = E * nu / ((1. + nu) * (1. - 2. * nu)), mu = 0.5 * E / (1. + nu);

  static const dealii::FE_Q<3>     fe(1);
  static const dealii::QGauss<3>   quadrature(2);
  dealii::LAPACKFullMatrix<double> stiffness(24, 24);
  std::array<double, 8>            mass{};
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      Tensor<2, 3> jacobian; // dx_i / dxi_j
      for (unsigned int a = 0; a < 8; ++a)
        jacobian += outer_product(Tensor<1, 3>(corners[a]), fe.shape_grad(a, quadrature.point(q)));
      const double                volume  = determinant(jacobian) * quadrature.weight(q);
      const Tensor<2, 3>          inverse = invert(jacobian);
      std::array<Tensor<1, 3>, 8> gradient;
      for (unsigned int a = 0; a < 8; ++a)
        {
          gradient[a] = fe.shape_grad(a, quadrature.point(q)) * inverse;
          mass[a] += density * fe.shape_value(a, quadrature.point(q)) * volume;
        }
      for (unsigned int a = 0; a < 8; ++a)
        for (unsigned int b = 0; b < 8; ++b)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              stiffness(3 * a + i, 3 * b + j) +=
                  volume *
                  (lambda * gradient[a][i] * gradient[b][j] + mu * gradient[a][j] * gradient[b][i] +
                   (i == j ? mu * (gradient[a] * gradient[b]) : 0.));
    }
  for (unsigned int r = 0; r < 24; ++r)
    for (unsigned int c = 0; c < 24; ++c)
      stiffness(r, c) /= std::sqrt(mass[r / 3] * mass[c / 3]);

  // Gershgorin's bound makes the search interval
  const double               limit = 1.01 * stiffness.linfty_norm();
  dealii::Vector<double>     eigenvalues;
  dealii::FullMatrix<double> eigenvectors;
  stiffness.compute_eigenvalues_symmetric(0.01 * limit, limit, 0., eigenvalues, eigenvectors);
  return std::sqrt(*std::max_element(eigenvalues.begin(), eigenvalues.end()));
}

} // namespace chaindrive::mesh
