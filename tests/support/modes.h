// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Natural modes and static displacements of a part, for the tests of elements.

#include "elastic.h"

#include <chaindrive/element/elastic_part.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/arpack_solver.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <complex>
#include <vector>

namespace test
{
using dealii::Vector;

/// Stiffness and mass matrix of one pattern.
struct LinearModel
{
  LinearModel() = default;

  /// Of a part, with its lumped masses.
  explicit LinearModel(const Hexahedra &reference)
  {
    reference.assemble(pattern, stiffness);
    mass.reinit(pattern);
    for (unsigned int i = 0; i < mass.m(); ++i)
      mass.diag_element(i) = reference.mass[i / 3];
  }

  /// Of all blocks of a part, with these masses of its nodes [kg].
  LinearModel(const element::ElasticPart &part, const std::vector<double> &masses)
  {
    std::vector<const element::ElementBlock *> blocks;
    for (const auto &block : part.blocks())
      blocks.push_back(block.get());
    element::assemble(blocks, static_cast<unsigned int>(masses.size()), pattern, stiffness);
    mass.reinit(pattern);
    for (unsigned int i = 0; i < mass.m(); ++i)
      mass.diag_element(i) = masses[i / 3];
  }

  /// Holds a degree of freedom still.
  void constrain(const unsigned int i)
  {
    const double large = 1e3 * stiffness.diag_element(i);
    for (auto entry = stiffness.begin(i); entry != stiffness.end(i); ++entry)
      {
        stiffness.set(entry->column(), i, 0.);
        entry->value() = 0.;
      }
    stiffness.set(i, i, large);
  }

  /// Holds component i at the reference positions for which @p held says so.
  void constrain(const Hexahedra                                             &reference,
                 const std::function<bool(const Point<3> &, unsigned int i)> &held)
  {
    for (unsigned int i = 0; i < stiffness.m(); ++i)
      if (held(reference.position[i / 3], i % 3))
        constrain(i);
  }

  /// Displacements under @p force, in a frame that accelerates with it where nothing is held:
  /// (K + shift M) u = f.
  Vector<double> displacements(const Vector<double> &force, const double shift = 0.) const
  {
    dealii::SparseMatrix<double> matrix(pattern);
    matrix.copy_from(stiffness);
    matrix.add(shift, mass);
    dealii::SparseDirectUMFPACK inverse;
    inverse.initialize(matrix);
    Vector<double> u(force.size());
    inverse.vmult(u, force);
    return u;
  }

  dealii::SparsityPattern      pattern;
  dealii::SparseMatrix<double> stiffness, mass;
};

struct Mode
{
  double         frequency; ///< Hz
  Vector<double> vector;
};

/// The @p n natural modes next to the frequency @p near [Hz], ascending.
inline std::vector<Mode>
natural_modes(const LinearModel &model, const double near, const unsigned int n)
{
  const unsigned int size  = model.stiffness.m();
  const double       shift = std::pow(2. * dealii::numbers::PI * near, 2);

  dealii::SparseMatrix<double> shifted(model.pattern);
  shifted.copy_from(model.stiffness);
  shifted.add(-shift, model.mass);
  dealii::SparseDirectUMFPACK inverse;
  inverse.initialize(shifted);

  dealii::SolverControl control(1000, 1e-10);
  dealii::ArpackSolver  solver(
      control,
      dealii::ArpackSolver::AdditionalData(
          2 * n + 15, dealii::ArpackSolver::largest_magnitude, /*symmetric*/ true));
  solver.set_shift(shift);
  Vector<double> start(size);
  for (unsigned int i = 0; i < size; ++i)
    start[i] = std::sin(1. + 12.9898 * i * i); // all modes take part
  solver.set_initial_vector(start);
  std::vector<std::complex<double>> values(n);
  std::vector<Vector<double>>       vectors(n, Vector<double>(size));
  solver.solve(model.stiffness, model.mass, inverse, values, vectors);

  std::vector<Mode> modes;
  for (unsigned int i = 0; i < n; ++i)
    modes.push_back(
        {std::sqrt(std::max(0., values[i].real())) / (2. * dealii::numbers::PI), vectors[i]});
  std::sort(modes.begin(), modes.end(), [](const Mode &a, const Mode &b) {
    return a.frequency < b.frequency;
  });
  return modes;
}

/// The share of @p field in the kinetic energy of a mode, 0 to 1.
inline double share(const LinearModel &model, const Mode &mode, const Vector<double> &field)
{
  const double product = model.mass.matrix_scalar_product(mode.vector, field);
  return product * product /
         (model.mass.matrix_norm_square(mode.vector) * model.mass.matrix_norm_square(field));
}

/// Displacements of a free part that turns about the z axis with the speed @p omega [rad/s].
inline Vector<double> centrifugal_displacements(const Hexahedra &reference, const double omega)
{
  const LinearModel model(reference);
  Vector<double>    force(model.stiffness.m());
  for (unsigned int i = 0; i < force.size(); ++i)
    if (i % 3 < 2)
      force[i] = reference.mass[i / 3] * omega * omega * reference.position[i / 3][i % 3];
  // The forces have no resultant; the shift, small beside elastic frequencies, holds rigid motions.
  return model.displacements(force, 1e6);
}

/// Sets a lane spinning about its z axis with the speed @p omega [rad/s], displaced by @p scale u
/// in its own axes, then turned by @p turned and moved by @p centre. Velocities are those of
/// leapfrog on a circle, half a step @p dt behind.
inline void set_spinning(Batch                &batch,
                         const unsigned int    lane,
                         const Vector<double> &u,
                         const double          scale,
                         const double          omega,
                         const double          dt,
                         const Tensor<2, 3>   &turned = dealii::unit_symmetric_tensor<3>(),
                         const Tensor<1, 3>   &centre = Tensor<1, 3>())
{
  const auto place = [&](const Point<3> &x, const unsigned int node) {
    Tensor<1, 3> p = x;
    for (unsigned int i = 0; i < 3; ++i)
      p[i] += scale * u[3 * node + i];
    return p;
  };
  batch.set(batch.position, lane, [&](const Point<3> &x, const unsigned int node) {
    return centre + turned * place(x, node);
  });
  batch.set(batch.velocity, lane, [&](const Point<3> &x, const unsigned int node) {
    const Tensor<1, 3> p = place(x, node);
    const double       a = 0.5 * omega * dt, v = 2. * std::sin(a) / dt;
    Tensor<1, 3>       w;
    w[0] = v * (-std::cos(a) * p[1] + std::sin(a) * p[0]);
    w[1] = v * (std::cos(a) * p[0] + std::sin(a) * p[1]);
    return turned * w;
  });
}
} // namespace test
