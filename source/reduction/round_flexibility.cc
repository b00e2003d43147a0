// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/basis.h>
#include <chaindrive/reduction/round_flexibility.h>
#include <chaindrive/reduction/side_flexibility.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
                                                  const Basis       &basis,
                                                  const bool         outside)
{
  std::vector<SidePatches> sides;
  for (const mesh::Surface surface : joint_sides(part))
    sides.emplace_back(part, nodes, surface);
  const auto surfaces   = part.mesh->get_boundary_ids();
  const bool is_outside = std::count(surfaces.begin(), surfaces.end(), mesh::roller_outside) != 0;
  if (outside && is_outside)
    sides.emplace_back(part, nodes, mesh::roller_outside);
  const SideFlexibility residual = residual_flexibility(
      side_flexibility(free, sides), patch_motions(sides, basis.modes), basis.omega);

  // of patches with those of another side, as many columns apart: the mean over all turns
  const auto mean_of = [&](const SidePatches &side,
                           const unsigned int first,
                           const SidePatches &other,
                           const unsigned int first_other) {
    const unsigned int  m = side.n_rings(), n = side.n_columns, m_other = other.n_rings();
    std::vector<double> value(std::size_t(m) * m_other * n, 0.);
    for (unsigned int r = 0; r < m; ++r)
      for (unsigned int s = 0; s < m_other; ++s)
        for (unsigned int d = 0; d < n; ++d)
          {
            double &sum = value[(std::size_t(r) * m_other + s) * n + d];
            for (unsigned int c = 0; c < n; ++c)
              sum += residual(first + c * m + r, first_other + (c + d) % n * m_other + s) / n;
          }
    return value;
  };

  std::vector<RoundFlexibility> round;
  unsigned int                  first = 0; // patch of the side
  for (const SidePatches &side : sides)
    {
      RoundFlexibility mean;
      mean.surface   = side.surface;
      mean.rings     = side.height;
      mean.n_columns = side.n_columns;
      mean.node      = side.node;
      mean.value     = mean_of(side, first, side, first);
      if (side.surface == mesh::roller_outside)
        {
          if (sides.size() != 2 || sides[0].n_columns != side.n_columns)
            throw std::logic_error("round_flexibilities: outside and bore have other columns");
          mean.to_bore = mean_of(side, first, sides[0], 0);
        }
      round.push_back(mean);
      first += side.n();
    }
  return round;
}
} // namespace chaindrive::reduction
