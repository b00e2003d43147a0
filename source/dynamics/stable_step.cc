// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/stable_step.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::dynamics
{
namespace
{
/// How a unit stretch of spring i pulls one of its two bodies: force direction and moment.
struct End
{
  unsigned int         spring;
  dealii::Tensor<1, 3> direction, moment;
};

struct Entry
{
  unsigned int row, column;
  double       value;
};

/// b_i^T M^-1 b_j of two ends on the same body.
double coupling(const End                  &a,
                const End                  &b,
                const double                inverse_mass,
                const dealii::Tensor<2, 3> &inverse_inertia)
{
  return inverse_mass * (a.direction * b.direction) + a.moment * (inverse_inertia * b.moment);
}

/// The largest eigenvalue of G_ij = sqrt(k_i k_j) g_ij, from above; @p x, positive, is iterated
/// towards the Perron vector of |G|.
double largest_eigenvalue(const std::vector<Entry>  &couplings,
                          const std::vector<double> &stiffness,
                          std::vector<double>       &x)
{
  std::vector<double> root(stiffness.size()), y(stiffness.size());
  for (unsigned int i = 0; i < root.size(); ++i)
    root[i] = std::sqrt(stiffness[i]);
  double bound = std::numeric_limits<double>::infinity();
  for (unsigned int iteration = 0; iteration < 2000; ++iteration)
    {
      std::fill(y.begin(), y.end(), 0.);
      for (const Entry &entry : couplings)
        y[entry.row] += std::abs(entry.value) * root[entry.column] * x[entry.column];
      double largest = 0., norm = 0.;
      for (unsigned int i = 0; i < x.size(); ++i)
        {
          y[i] *= root[i];
          largest = std::max(largest, y[i] / x[i]);
          norm    = std::max(norm, y[i]);
        }
      const bool converged = largest > bound * (1. - 1e-6);
      bound                = std::min(bound, largest);
      if (bound == 0. || (converged && iteration > 20))
        break;
      // the small constant keeps x positive where a spring is much softer than its neighbours
      for (unsigned int i = 0; i < x.size(); ++i)
        x[i] = y[i] / norm + 1e-6;
    }
  return bound;
}
} // namespace

double stable_step(const World &world, const std::vector<Spring> &springs)
{
  if (springs.empty())
    return std::numeric_limits<double>::infinity();

  std::vector<dealii::Tensor<2, 3>> inverse_inertia(world.n_bodies());
  for (const World::Rotation &rotation : world.rotations)
    {
      const dealii::Tensor<2, 3> &r = world.frames[rotation.body].rotation;
      dealii::Tensor<2, 3>        diagonal;
      for (unsigned int d = 0; d < 3; ++d)
        diagonal[d][d] = 1. / rotation.inertia[d];
      inverse_inertia[rotation.body] = r * diagonal * dealii::transpose(r);
    }
  for (const World::Hub &hub : world.hubs)
    if (!hub.prescribed)
      inverse_inertia[hub.body][2][2] = 1. / hub.inertia;

  std::vector<std::vector<End>> ends(world.n_bodies());
  for (unsigned int i = 0; i < springs.size(); ++i)
    {
      const Spring &s = springs[i];
      const auto    fasten =
          [&](const unsigned int body, const dealii::Tensor<1, 3> &at, const double sign) {
            ends[body].push_back(
                {i,
                 sign * s.direction,
                 dealii::cross_product_3d(at - world.frames[body].position, sign * s.direction)});
          };
      fasten(s.first, s.first_at, -1.);
      fasten(s.second, s.second_at, 1.);
    }

  // entries of one pair of springs that share two bodies are added with their signs before the
  // absolute value is taken
  std::vector<Entry> entries;
  for (unsigned int body = 0; body < world.n_bodies(); ++body)
    for (const End &a : ends[body])
      for (const End &b : ends[body])
        {
          const double value = coupling(a, b, world.inverse_mass[body], inverse_inertia[body]);
          if (value != 0.)
            entries.push_back({a.spring, b.spring, value});
        }
  std::sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  std::vector<Entry> couplings;
  for (const Entry &entry : entries)
    if (!couplings.empty() && couplings.back().row == entry.row &&
        couplings.back().column == entry.column)
      couplings.back().value += entry.value;
    else
      couplings.push_back(entry);

  std::vector<double> stiffness, damping, x(springs.size(), 1.);
  for (const Spring &spring : springs)
    {
      stiffness.push_back(spring.stiffness);
      damping.push_back(spring.damping);
    }
  double step = stable_step_of(largest_eigenvalue(couplings, stiffness, x),
                               largest_eigenvalue(couplings, damping, x));
  // from a safe step to a larger one that is safe too, since the springs soften as it grows
  for (double before = 0.; std::isfinite(step) && step > 1.0001 * before;)
    {
      before = step;
      std::vector<double> both(stiffness);
      for (unsigned int i = 0; i < both.size(); ++i)
        both[i] += 2. / step * damping[i];
      step = 2. / std::sqrt(largest_eigenvalue(couplings, both, x));
    }
  return step;
}

double stable_step_of(const double stiffness, const double damping)
{
  return 4. / (damping + std::sqrt(damping * damping + 4. * stiffness));
}
} // namespace chaindrive::dynamics
