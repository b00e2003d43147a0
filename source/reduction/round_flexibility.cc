// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/basis.h>
#include <chaindrive/reduction/round_flexibility.h>
#include <chaindrive/reduction/side_flexibility.h>

#include <cmath>

namespace chaindrive::reduction
{
double RoundFlexibility::compliance(const Vector &forces) const
{
  const unsigned int  n = n_columns, m = n_rings();
  std::vector<double> away(node.size());
  for (unsigned int i = 0; i < node.size(); ++i)
    {
      const double angle = 2. * dealii::numbers::PI * (i % n) / n;
      away[i] = std::cos(angle) * forces[3 * node[i]] + std::sin(angle) * forces[3 * node[i] + 1];
    }
  double sum = 0.;
  for (unsigned int r = 0; r < m; ++r)
    for (unsigned int s = 0; s < m; ++s)
      for (unsigned int c = 0; c < n; ++c)
        for (unsigned int d = 0; d < n; ++d)
          sum += away[r * n + c] * at(r, s, d + n - c) * away[s * n + d];
  return sum;
}

std::vector<RoundFlexibility> round_flexibilities(const FreePart    &free,
                                                  const mesh::Part  &part,
                                                  const mesh::Nodes &nodes,
                                                  const Basis       &basis)
{
  std::vector<SidePatches> sides;
  for (const mesh::Surface surface : joint_sides(part))
    sides.emplace_back(part, nodes, surface);
  const SideFlexibility residual = residual_flexibility(
      side_flexibility(free, sides), patch_motions(sides, basis.modes), basis.omega);

  std::vector<RoundFlexibility> round;
  unsigned int                  first = 0; // patch of the side
  for (const SidePatches &side : sides)
    {
      RoundFlexibility   mean;
      const unsigned int m = side.n_rings(), n = side.n_columns;
      mean.surface   = side.surface;
      mean.rings     = side.height;
      mean.n_columns = n;
      mean.node      = side.node;
      mean.value.assign(std::size_t(m) * m * n, 0.);
      for (unsigned int r = 0; r < m; ++r)
        for (unsigned int s = 0; s < m; ++s)
          for (unsigned int d = 0; d < n; ++d)
            {
              double &sum = mean.value[(std::size_t(r) * m + s) * n + d];
              for (unsigned int c = 0; c < n; ++c)
                sum += residual(first + c * m + r, first + (c + d) % n * m + s) / n;
            }
      round.push_back(mean);
      first += side.n();
    }
  return round;
}
} // namespace chaindrive::reduction
