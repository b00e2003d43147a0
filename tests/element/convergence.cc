// SPDX-License-Identifier: LGPL-2.1-or-later
// Static displacements of a curved block of general hexahedra under the volume forces of a known
// smooth field, held at its faces: their error is of second order in the size of cells. (Order of
// natural frequencies: ring_modes; in the step: time_order.)
#include "../support/modes.h"

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

using namespace test;

namespace
{
constexpr double size = 1e-2; // m

/// The unit cube as a block with curved faces; none of its cells is a parallelepiped.
Point<3> curved(const Point<3> &x)
{
  return size * Point<3>(x[0] + 0.15 * std::sin(2. * x[1]) * x[2],
                         x[1] + 0.1 * x[0] * x[0] * (1. + x[2]),
                         x[2] * (1. + 0.2 * x[0] * x[1]));
}

/// u_i = sin(k_i . x) micrometres and the volume force that it takes, N/m3.
struct Field
{
  Tensor<1, 3> wave(const unsigned int i) const
  {
    Tensor<1, 3> k;
    for (unsigned int d = 0; d < 3; ++d)
      k[d] = (1. + (i + d) % 3) / size;
    return k;
  }
  double displacement(const Point<3> &x, const unsigned int i) const
  {
    return 1e-6 * std::sin(wave(i) * Tensor<1, 3>(x));
  }
  /// -(mu div grad u + (lambda + mu) grad div u)
  double force(const Point<3> &x, const unsigned int i, const double lambda, const double mu) const
  {
    double f = mu * wave(i).norm_square() * displacement(x, i);
    for (unsigned int j = 0; j < 3; ++j)
      f += (lambda + mu) * wave(j)[i] * wave(j)[j] * displacement(x, j);
    return f;
  }
};
} // namespace

int main()
{
  const Material material;
  const Field    field;
  for (const auto &formulation : formulations)
    {
      std::array<double, 3> error{};
      for (unsigned int level = 0; level < 3; ++level)
        {
          const unsigned int n    = 4u << level;
          mesh::Part         body = brick({1., 1., 1.}, {n, n, n});
          dealii::GridTools::transform(curved, *body.mesh);
          std::vector<bool> outside(body.mesh->n_vertices(), false);
          for (const auto &cell : body.mesh->active_cell_iterators())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary())
                for (const unsigned int v : face->vertex_indices())
                  outside[face->vertex_index(v)] = true;

          const mesh::Nodes nodes(body);
          const Hexahedra   reference(body, nodes, material, formulation.first);
          LinearModel       model(reference);
          Vector<double>    exact(model.stiffness.m()), force(exact), held(exact), u(exact);
          for (unsigned int i = 0; i < exact.size(); ++i)
            {
              exact[i] = field.displacement(reference.position[i / 3], i % 3);
              force[i] =
                  reference.mass[i / 3] / material.density *
                  field.force(reference.position[i / 3], i % 3, reference.lambda, reference.mu);
              if (outside[nodes.vertex[i / 3]])
                held[i] = exact[i];
            }
          Vector<double> pull(exact.size());
          model.stiffness.vmult(pull, held);
          force -= pull;
          for (unsigned int i = 0; i < exact.size(); ++i)
            if (outside[nodes.vertex[i / 3]])
              {
                model.constrain(i);
                force[i] = 0.;
              }
          dealii::SolverControl            control(2000, 1e-12 * force.l2_norm());
          dealii::SolverCG<Vector<double>> solver(control);
          dealii::PreconditionSSOR<dealii::SparseMatrix<double>> preconditioner;
          preconditioner.initialize(model.stiffness, 1.2);
          solver.solve(model.stiffness, u, force, preconditioner);
          u += held;
          u -= exact;
          error[level] =
              std::sqrt(model.mass.matrix_norm_square(u) / model.mass.matrix_norm_square(exact));
        }
      std::cout << formulation.second << ": error on the finest mesh " << std::fixed
                << std::setprecision(2) << 100. * error[2] << " %, order in the size of cells "
                << std::setprecision(1) << std::log2(error[0] / error[1]) << ' '
                << std::log2(error[1] / error[2]) << '\n';
    }
}
