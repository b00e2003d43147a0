// SPDX-License-Identifier: LGPL-2.1-or-later
// Natural frequencies of one free box of edges 2a, 2b, 2c with lumped masses, all 18 that are not
// rigid, against closed forms. Displacements u_i = x_j / a_j and the hourglass patterns of the
// vertices have diagonal mass; the strain energy of the hourglass patterns couples
//
//   bending, u_x = xy/ab with u_z = yz/bc: one pair for each middle coordinate,
//   torsion, u_x = yz/bc, u_y = zx/ca, u_z = xy/ab: all three,
//   u_i = xyz/abc: none.
//
// Full integration is exact for a parallelepiped: also against a stiffness of deal.II's FEValues
// with five points along each edge. Incompatible modes free the pairs of shear and of the strain
// across: they bend as plates do.
#include "../support/elastic.h"

#include <chaindrive/element/hexahedron_stiffness.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <vector>

using namespace test;

namespace
{
mesh::Part box(const Tensor<2, 3> &edges)
{
  return part([&](dealii::Triangulation<3> &mesh) {
    std::vector<Point<3>>            corners;
    std::vector<dealii::CellData<3>> cells(1);
    for (unsigned int v = 0; v < 8; ++v)
      {
        Point<3> x;
        for (unsigned int d = 0; d < 3; ++d)
          x += ((v >> d) & 1) * edges[d];
        corners.push_back(x);
        cells[0].vertices[v] = v;
      }
    mesh.create_triangulation(corners, cells, {});
  });
}

/// Squares of the 18 frequencies [1/s2], ascending, of the box of half edges @p h.
std::vector<double> closed_forms(const std::array<double, 3> &h,
                                 const Hexahedra             &reference,
                                 const double                 rho,
                                 const bool                   incompatible)
{
  const double lambda = reference.lambda, mu = reference.mu, M = lambda + 2. * mu;
  // a plate is free across: its modulus and its part that couples
  const double modulus  = incompatible ? M - lambda * lambda / M : M,
               coupling = incompatible ? lambda - lambda * lambda / M : lambda;

  std::vector<double>           squares;
  dealii::SymmetricTensor<2, 3> stretch, torsion;
  for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
      const double       a = 1. / h[i], b = 1. / h[j], c = 1. / h[k];
      stretch[i][i] = M * a * a / rho;
      stretch[i][j] = lambda * a * b / rho;
      torsion[i][i] = mu * (b * b + c * c) / (3. * rho);
      torsion[i][j] = mu * a * b / (3. * rho);

      squares.push_back(mu * (a * a + b * b) / rho); // shear
      dealii::SymmetricTensor<2, 2> bending;         // the middle coordinate is k
      const double                  shear = incompatible ? 0. : mu * c * c;
      bending[0][0]                       = (modulus * a * a + shear) / (3. * rho);
      bending[1][1]                       = (modulus * b * b + shear) / (3. * rho);
      bending[0][1]                       = coupling * a * b / (3. * rho);
      for (const double square : dealii::eigenvalues(bending))
        squares.push_back(square);
      squares.push_back((M * a * a + mu * (b * b + c * c)) / (9. * rho)); // u_i = xyz/abc
    }
  for (const auto &coupled : {stretch, torsion})
    for (const double square : dealii::eigenvalues(coupled))
      squares.push_back(square);
  std::sort(squares.begin(), squares.end());
  return squares;
}

/// Stiffness with many points of Gauss' rule.
dealii::FullMatrix<double> integrated(const mesh::Part &body, const double lambda, const double mu)
{
  const dealii::FE_Q<3> fe(1);
  dealii::DoFHandler<3> dofs(*body.mesh);
  dofs.distribute_dofs(fe);
  dealii::FEValues<3> values(
      fe, dealii::QGauss<3>(5), dealii::update_gradients | dealii::update_JxW_values);
  values.reinit(dofs.begin_active());
  dealii::FullMatrix<double> k(24, 24);
  for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int b = 0; b < 8; ++b)
        {
          const Tensor<1, 3> A = values.shape_grad(a, q), B = values.shape_grad(b, q);
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              k(3 * a + i, 3 * b + j) += values.JxW(q) * (lambda * A[i] * B[j] + mu * A[j] * B[i] +
                                                          (i == j ? mu * (A * B) : 0.));
        }
  return k;
}

Tensor<2, 3> edges(const std::array<double, 3> &length, const double shear)
{
  Tensor<2, 3> e;
  for (unsigned int d = 0; d < 3; ++d)
    e[d][d] = length[d];
  e[1][0] = shear * length[1];
  e[2][0] = 0.5 * shear * length[2];
  e[2][1] = -shear * length[2];
  return e;
}
} // namespace

int main()
{
  const Material material;
  for (const auto &length : {std::array<double, 3>{{1e-3, 1e-3, 1e-3}},
                             {{1e-3, 0.7e-3, 2.3e-3}},
                             {{3e-3, 0.4e-3, 0.3e-3}}})
    for (const auto &formulation : formulations)
      {
        if (formulation.first == Formulation::one_point)
          continue;
        const mesh::Part body = box(edges(length, 0.));
        const Hexahedra  reference(body, material, formulation.first);
        const auto expected = closed_forms({{0.5 * length[0], 0.5 * length[1], 0.5 * length[2]}},
                                           reference,
                                           material.density,
                                           formulation.first == Formulation::enhanced);
        std::array<double, 8> masses;
        masses.fill(reference.mass[0]);
        const auto omega = element::natural_frequencies(reference.element_stiffness(0), masses);
        double     worst = 0.;
        for (unsigned int m = 0; m < 18; ++m)
          worst = std::max(worst, std::abs(omega[m + 6] / std::sqrt(expected[m]) - 1.));
        std::cout << "box " << 1e3 * length[0] << " x " << 1e3 * length[1] << " x "
                  << 1e3 * length[2] << ", " << formulation.second
                  << ": lowest and highest over closed form " << std::fixed << std::setprecision(6)
                  << omega[6] / std::sqrt(expected[0]) << ' ' << omega[23] / std::sqrt(expected[17])
                  << std::defaultfloat << "; all 18 to 1e-9: " << (worst < 1e-9 ? "yes" : "NO")
                  << '\n';
      }

  for (const double shear : {0., 0.3, 0.8})
    {
      const mesh::Part body = box(edges({{1e-3, 0.7e-3, 1.3e-3}}, shear));
      const Hexahedra  reference(body, material, Formulation::full);
      auto             difference = integrated(body, reference.lambda, reference.mu);
      const double     norm       = difference.frobenius_norm();
      // the element's vertices may be renumbered and are nodes in an order of their own
      const mesh::Nodes           nodes(body);
      const auto                  k = reference.element_stiffness(0);
      std::array<unsigned int, 8> vertex{};
      for (unsigned int a = 0; a < 8; ++a)
        vertex[a] = nodes.vertex[reference.vertices[0].node[a]];
      for (unsigned int a = 0; a < 8; ++a)
        for (unsigned int b = 0; b < 8; ++b)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              difference(3 * vertex[a] + i, 3 * vertex[b] + j) -= k(3 * a + i, 3 * b + j);
      std::cout << "parallelepiped, shear " << shear << ", full: the exact integral to 1e-12: "
                << (difference.frobenius_norm() < 1e-12 * norm ? "yes" : "NO") << '\n';
    }
}
