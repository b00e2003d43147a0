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
            entries.push_back(
                {a.spring,
                 b.spring,
                 value * std::sqrt(springs[a.spring].stiffness * springs[b.spring].stiffness)});
        }
  std::sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  std::vector<Entry> matrix;
  for (const Entry &entry : entries)
    if (!matrix.empty() && matrix.back().row == entry.row && matrix.back().column == entry.column)
      matrix.back().value += entry.value;
    else
      matrix.push_back(entry);

  std::vector<double> x(springs.size(), 1.), y(springs.size());
  double              bound = std::numeric_limits<double>::infinity();
  for (unsigned int iteration = 0; iteration < 2000; ++iteration)
    {
      std::fill(y.begin(), y.end(), 0.);
      for (const Entry &entry : matrix)
        y[entry.row] += std::abs(entry.value) * x[entry.column];
      double largest = 0., norm = 0.;
      for (unsigned int i = 0; i < x.size(); ++i)
        {
          largest = std::max(largest, y[i] / x[i]);
          norm    = std::max(norm, y[i]);
        }
      const bool converged = largest > bound * (1. - 1e-6);
      bound                = std::min(bound, largest);
      if (bound == 0.)
        return std::numeric_limits<double>::infinity();
      if (converged && iteration > 20)
        break;
      // the small constant keeps x positive where a spring is much softer than its neighbours
      for (unsigned int i = 0; i < x.size(); ++i)
        x[i] = y[i] / norm + 1e-6;
    }

  const double frequency  = std::sqrt(bound);
  double       relaxation = 0.; // largest damping time c/k
  for (const Spring &spring : springs)
    if (spring.stiffness > 0.)
      relaxation = std::max(relaxation, spring.damping / spring.stiffness);
  const double ratio = 0.5 * relaxation * frequency;
  return stable_step_of_mode(frequency, ratio);
}

double stable_step_of_mode(const double frequency, const double ratio)
{
  return 2. / frequency * (std::sqrt(1. + ratio * ratio) - ratio);
}
} // namespace chaindrive::dynamics
