// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/reference.h>
#include <chaindrive/mesh/stiffness.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::element
{
namespace
{
/// The hourglass vectors of deal.II's vertices, see Hexahedron.
double h(const unsigned int alpha, const unsigned int vertex)
{
  const double x = (vertex & 1) ? 1. : -1., y = (vertex & 2) ? 1. : -1.,
               z = (vertex & 4) ? 1. : -1.;
  switch (alpha)
    {
    case 0:
      return x * y;
    case 1:
      return y * z;
    case 2:
      return z * x;
    default:
      return x * y * z;
    }
}

/// The mean gradient and what of the hourglass vectors is linear.
Hexahedron make_hexahedron(const mesh::Corners                   &corners,
                           const std::array<mesh::GaussPoint, 8> &points,
                           const std::array<unsigned int, 8>     &nodes)
{
  Hexahedron element{};
  for (const mesh::GaussPoint &point : points)
    {
      element.volume += point.volume;
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int a = 0; a < 8; ++a)
          element.gradient[j][a] += point.volume * point.gradient[a][j];
    }
  for (unsigned int a = 0; a < 8; ++a)
    {
      element.node[a] = nodes[a];
      for (unsigned int j = 0; j < 3; ++j)
        {
          element.gradient[j][a] /= element.volume;
          for (unsigned int alpha = 0; alpha < 4; ++alpha)
            element.shift[alpha][j] += h(alpha, a) * corners[a][j];
        }
    }
  return element;
}

/// gamma_alpha = h_alpha - B_j (h_alpha . X_j): linear displacements have no part in it.
dealii::FullMatrix<double> hourglass_vectors(const Hexahedron &element)
{
  dealii::FullMatrix<double> gamma(4, 8);
  for (unsigned int alpha = 0; alpha < 4; ++alpha)
    for (unsigned int a = 0; a < 8; ++a)
      {
        gamma(alpha, a) = h(alpha, a);
        for (unsigned int j = 0; j < 3; ++j)
          gamma(alpha, a) -= element.gradient[j][a] * element.shift[alpha][j];
      }
  return gamma;
}

/// The part of @p k that acts on the hourglass amplitudes. An element that passes the patch test is
/// K = V B^T C B + Gamma^T K_h Gamma. Displacements G_alpha with gamma_alpha . G_beta = 1 or 0 and
/// no mean gradient, one for each amplitude, therefore give K_h = G K G^T.
HourglassStiffness condense(const dealii::FullMatrix<double> &k,
                            const Hexahedron                 &element,
                            const mesh::Corners              &corners)
{
  const dealii::FullMatrix<double> gamma = hourglass_vectors(element);
  dealii::FullMatrix<double>       products(4, 4), inverse(4, 4), g(4, 8);
  gamma.mTmult(products, gamma);
  inverse.invert(products);
  inverse.mmult(g, gamma);
  for (unsigned int alpha = 0; alpha < 4; ++alpha)
    for (unsigned int j = 0; j < 3; ++j)
      {
        double gradient = 0.;
        for (unsigned int a = 0; a < 8; ++a)
          gradient += element.gradient[j][a] * g(alpha, a);
        for (unsigned int a = 0; a < 8; ++a) // a linear field changes no amplitude
          g(alpha, a) -= gradient * (corners[a][j] - corners[0][j]);
      }

  HourglassStiffness result{};
  for (unsigned int alpha = 0; alpha < 4; ++alpha)
    for (unsigned int beta = 0; beta < 4; ++beta)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int a = 0; a < 8; ++a)
            for (unsigned int b = 0; b < 8; ++b)
              result.k[3 * alpha + i][3 * beta + j] +=
                  g(alpha, a) * k(3 * a + i, 3 * b + j) * g(beta, b);
  return result;
}

/// The same stiffness of every amplitude, after Flanagan and Belytschko (1981):
/// coefficient (lambda + 2 mu) V B_ja B_ja / gamma . gamma.
double
hourglass_stiffness_of(const Hexahedron &element, const double coefficient, const double modulus)
{
  double gradients = 0.;
  for (const auto &row : element.gradient)
    for (const double b : row)
      gradients += b * b;
  const double norm = hourglass_vectors(element).frobenius_norm();
  return coefficient * modulus * element.volume * gradients / (0.25 * norm * norm);
}
} // namespace

Reference::Reference(const mesh::Part           &part,
                     const mesh::Nodes          &nodes,
                     const parameters::Material &material,
                     const Formulation           how,
                     const double                hourglass_coefficient)
    : formulation(how), mass(nodes.mass), position(nodes.position)
{
  const double E = material.youngs_modulus, nu = material.poissons_ratio;
  lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
  mu     = 0.5 * E / (1. + nu);

  for (const auto &cell : part.mesh->active_cell_iterators())
    {
      if (cell->material_id() == mesh::hub_zone)
        continue;
      const mesh::Corners corners = mesh::corners_of(cell);
      const auto          gauss   = mesh::gauss_points(corners);
      elements.push_back(make_hexahedron(corners, gauss, nodes.cells[elements.size()]));
      const Hexahedron &element = elements.back();
      switch (formulation)
        {
        case Formulation::one_point:
          hourglass_stiffness.push_back(
              hourglass_stiffness_of(element, hourglass_coefficient, lambda + 2. * mu));
          break;
        case Formulation::enhanced:
          hourglass.push_back(condense(mesh::stiffness(gauss, material, true), element, corners));
          break;
        case Formulation::full:
          points.push_back({});
          for (unsigned int q = 0; q < 8; ++q)
            {
              points.back().volume[q] = gauss[q].volume;
              for (unsigned int j = 0; j < 3; ++j)
                for (unsigned int a = 0; a < 8; ++a)
                  points.back().gradient[q][j][a] = gauss[q].gradient[a][j];
            }
          break;
        }
    }
}

ForceArguments Reference::arguments() const
{
  ForceArguments arg{};
  arg.n_elements          = n_elements();
  arg.elements            = elements.data();
  arg.hourglass           = hourglass.data();
  arg.hourglass_stiffness = hourglass_stiffness.data();
  arg.points              = points.data();
  arg.lambda              = lambda;
  arg.mu                  = mu;
  return arg;
}

dealii::FullMatrix<double> Reference::element_stiffness(const unsigned int e) const
{
  dealii::FullMatrix<double> k(24, 24);

  const auto add_point = [&](const double(&gradient)[3][8], const double volume) {
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int b = 0; b < 8; ++b)
        {
          double product = 0.;
          for (unsigned int j = 0; j < 3; ++j)
            product += gradient[j][a] * gradient[j][b];
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              k(3 * a + i, 3 * b + j) +=
                  volume * (lambda * gradient[i][a] * gradient[j][b] +
                            mu * gradient[j][a] * gradient[i][b] + (i == j ? mu * product : 0.));
        }
  };
  if (formulation == Formulation::full)
    {
      for (unsigned int q = 0; q < 8; ++q)
        add_point(points[e].gradient[q], points[e].volume[q]);
      return k;
    }

  add_point(elements[e].gradient, elements[e].volume);
  const dealii::FullMatrix<double> gamma = hourglass_vectors(elements[e]);
  for (unsigned int alpha = 0; alpha < 4; ++alpha)
    for (unsigned int beta = 0; beta < 4; ++beta)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const double stiffness = formulation == Formulation::enhanced ?
                                         hourglass[e].k[3 * alpha + i][3 * beta + j] :
                                         (alpha == beta && i == j ? hourglass_stiffness[e] : 0.);
            if (stiffness != 0.)
              for (unsigned int a = 0; a < 8; ++a)
                for (unsigned int b = 0; b < 8; ++b)
                  k(3 * a + i, 3 * b + j) += gamma(alpha, a) * stiffness * gamma(beta, b);
          }
  return k;
}

void Reference::assemble(dealii::SparsityPattern      &pattern,
                         dealii::SparseMatrix<double> &matrix) const
{
  const auto unknowns = [](const Hexahedron &element) {
    std::vector<dealii::types::global_dof_index> indices;
    for (const unsigned int node : element.node)
      for (unsigned int i = 0; i < 3; ++i)
        indices.push_back(3 * node + i);
    return indices;
  };

  dealii::DynamicSparsityPattern dynamic(3 * n_nodes());
  for (const Hexahedron &element : elements)
    {
      const auto indices = unknowns(element);
      for (const auto row : indices)
        dynamic.add_entries(row, indices.begin(), indices.end());
    }
  pattern.copy_from(dynamic);
  matrix.reinit(pattern);
  for (unsigned int e = 0; e < n_elements(); ++e)
    matrix.add(unknowns(elements[e]), element_stiffness(e));
}

double Reference::largest_frequency() const
{
  dealii::SparsityPattern      pattern;
  dealii::SparseMatrix<double> matrix;
  assemble(pattern, matrix);

  dealii::DiagonalMatrix<dealii::Vector<double>> inverse_mass;
  dealii::Vector<double> diagonal(3 * n_nodes()), start(3 * n_nodes()), force(3 * n_nodes());
  for (unsigned int i = 0; i < 3 * n_nodes(); ++i)
    {
      diagonal[i] = 1. / mass[i / 3];
      start[i]    = std::sin(1. + 12.9898 * i * i); // all modes take part
    }
  inverse_mass.reinit(diagonal);
  matrix.vmult(force, start); // free of the rigid modes, which the matrix does not see

  // The conjugate gradient method finds the extreme eigenvalues of M^-1 K on its way (Saad,
  // Iterative Methods for Sparse Linear Systems, 6.7).
  double                                   largest = 0.;
  dealii::IterationNumberControl           control(400, 1e-8 * force.l2_norm());
  dealii::SolverCG<dealii::Vector<double>> solver(control);
  solver.connect_eigenvalues_slot([&](const std::vector<double> &values) {
    for (const double value : values)
      largest = std::max(largest, value);
  });
  start = 0.;
  solver.solve(matrix, start, force, inverse_mass);
  return std::sqrt(largest);
}

std::size_t Reference::memory_consumption() const
{
  return elements.size() * sizeof(Hexahedron) + hourglass.size() * sizeof(HourglassStiffness) +
         hourglass_stiffness.size() * sizeof(double) + points.size() * sizeof(PointGradients) +
         mass.size() * (sizeof(double) + sizeof(dealii::Point<3>));
}
} // namespace chaindrive::element
