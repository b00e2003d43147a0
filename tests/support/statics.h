// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies at rest in contact: Newton's method for K u = p + c(u), with the assembled stiffnesses of
// the bodies one after the other and the contact forces c of the program. The derivatives of c are
// differences of c, degree of freedom by degree of freedom.

#include "modes.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace test
{
struct Statics
{
  using Forces = std::function<void(const Vector<double> &u, Vector<double> &c)>;

  explicit Statics(const std::vector<const Hexahedra *> &bodies)
  {
    for (const Hexahedra *body : bodies)
      {
        first.push_back(size);
        size += 3 * body->n_nodes();
      }
    first.push_back(size);
    for (const Hexahedra *body : bodies)
      stiffness.push_back(std::make_unique<LinearModel>(*body));
    held.assign(size, false);
    u.reinit(size);
    load.reinit(size);
  }

  /// Solves for what of @p u is not held; @p touched lists the degrees of freedom that @p contact
  /// looks at. Returns the number of iterations until the forces are balanced to @p tolerance [N],
  /// or 0 if it does not come to an end.
  unsigned int
  solve(const Forces &contact, const std::vector<unsigned int> &touched, const double tolerance)
  {
    const double   nudge = 1e-10; // m
    Vector<double> c(size), moved(size), residual(size), step(size);
    for (unsigned int iteration = 1; iteration <= 60; ++iteration)
      {
        contact(u, c);
        residual = c;
        residual += load;
        for (unsigned int b = 0; b < stiffness.size(); ++b)
          {
            Vector<double> part(first[b + 1] - first[b]), force(part.size());
            for (unsigned int i = 0; i < part.size(); ++i)
              part[i] = u[first[b] + i];
            stiffness[b]->stiffness.vmult(force, part);
            for (unsigned int i = 0; i < part.size(); ++i)
              residual[first[b] + i] -= force[i];
          }
        for (unsigned int i = 0; i < size; ++i)
          if (held[i])
            residual[i] = 0.;
        if (residual.linfty_norm() < tolerance)
          return iteration;

        struct Entry
        {
          unsigned int row, column;
          double       value;
        };
        std::vector<Entry> entries;
        for (unsigned int b = 0; b < stiffness.size(); ++b)
          for (const auto &entry : stiffness[b]->stiffness)
            entries.push_back({static_cast<unsigned int>(first[b] + entry.row()),
                               static_cast<unsigned int>(first[b] + entry.column()),
                               entry.value()});
        for (const unsigned int j : touched)
          {
            if (held[j])
              continue;
            const double before = u[j];
            u[j] += nudge;
            contact(u, moved);
            u[j] = before;
            for (const unsigned int i : touched)
              if (moved[i] != c[i])
                entries.push_back({i, j, (c[i] - moved[i]) / nudge});
          }
        dealii::DynamicSparsityPattern dynamic(size);
        for (const Entry &entry : entries)
          if (entry.row == entry.column || !(held[entry.row] || held[entry.column]))
            dynamic.add(entry.row, entry.column);
        dealii::SparsityPattern pattern;
        pattern.copy_from(dynamic);
        dealii::SparseMatrix<double> matrix(pattern);
        for (const Entry &entry : entries)
          if (entry.row == entry.column || !(held[entry.row] || held[entry.column]))
            matrix.add(entry.row, entry.column, entry.value);
        dealii::SparseDirectUMFPACK inverse;
        inverse.initialize(matrix);
        inverse.vmult(step, residual);
        u += step;
      }
    return 0;
  }

  std::vector<unsigned int>                 first; ///< degree of freedom of each body; the end
  unsigned int                              size = 0;
  std::vector<std::unique_ptr<LinearModel>> stiffness;
  std::vector<bool>                         held; ///< keeps its value of u
  Vector<double>                            u;    ///< m
  Vector<double>                            load; ///< N
};
} // namespace test
