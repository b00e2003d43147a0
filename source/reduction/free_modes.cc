// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/free_modes.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/lac/arpack_solver.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::reduction
{
namespace
{
constexpr unsigned int n_at_a_time = 12, n_lanczos = 3 * n_at_a_time;

/// G without the part of the modes that are @p found, whose eigenvalues in the eyes of ARPACK are
/// then 0 as those of rigid motions are.
struct Deflated
{
  const FreePart          &part;
  const std::vector<Mode> &found;

  void remove_found(Vector &u) const
  {
    for (const Mode &mode : found)
      u.add(-part.mass_product(mode.vector, u), mode.vector);
  }

  void vmult(Vector &u, const Vector &f) const
  {
    u = part.displacement(f);
    remove_found(u);
  }
};

/// The lowest modes that are not among the @p found: Lanczos' method on G M (Lehoucq, Sorensen,
/// Yang, ARPACK Users' Guide, SIAM 1998).
std::vector<Mode> next_modes(const FreePart &part, const std::vector<Mode> &found)
{
  const unsigned int n = part.n_unknowns();
  const Deflated     inverse{part, found};

  dealii::SolverControl control(1000, 1e-13);
  dealii::ArpackSolver  solver(control,
                              dealii::ArpackSolver::AdditionalData(
                                  n_lanczos, dealii::ArpackSolver::largest_magnitude, true));
  Vector                force(n), start(n);
  for (unsigned int i = 0; i < n; ++i)
    force[i] = std::sin(1. + 12.9898 * i * i); // all modes take part
  inverse.vmult(start, force);
  start /= start.l2_norm();
  solver.set_initial_vector(start);
  std::vector<std::complex<double>> values(n_at_a_time);
  std::vector<Vector>               vectors(n_at_a_time, Vector(n));
  solver.solve(part.stiffness(), part.mass(), inverse, values, vectors);

  std::vector<Mode> modes;
  for (Vector &vector : vectors)
    {
      inverse.remove_found(vector);
      for (const Mode &mode : modes) // of equal frequency
        vector.add(-part.mass_product(mode.vector, vector), mode.vector);
      vector /= std::sqrt(part.mass_product(vector, vector));
      modes.push_back({std::sqrt(part.stiffness().matrix_norm_square(vector)), vector});
    }
  std::sort(
      modes.begin(), modes.end(), [](const Mode &a, const Mode &b) { return a.omega < b.omega; });
  return modes;
}

/// How far the @p mode is from one, |omega^2 G M phi - phi| with the norm of M: relative.
double residual(const FreePart &part, const Mode &mode)
{
  Vector force(part.n_unknowns());
  part.mass().vmult(force, mode.vector);
  Vector rest = part.displacement(force);
  rest.sadd(mode.omega * mode.omega, -1., mode.vector);
  return std::sqrt(part.mass_product(rest, rest));
}
} // namespace

std::vector<Mode> free_modes(const FreePart &part, const double highest)
{
  std::vector<Mode> found;
  for (;;)
    {
      if (part.n_unknowns() < 2 * (n_lanczos + found.size()))
        throw InputError("The mesh of the " + part.name() + " is too coarse for its modes up to " +
                         to_text(1e-3 * highest / (2. * dealii::numbers::PI), 4) + " kHz.");
      const std::vector<Mode> next  = next_modes(part, found);
      const std::size_t       known = found.size();
      for (const Mode &mode : next)
        if (mode.omega <= highest)
          {
            if (residual(part, mode) > 1e-6)
              throw RunError("The natural modes of the " + part.name() + " were not found.");
            found.push_back(mode);
          }
      if (found.size() == known)
        break;
    }
  std::sort(
      found.begin(), found.end(), [](const Mode &a, const Mode &b) { return a.omega < b.omega; });
  return found;
}
} // namespace chaindrive::reduction
