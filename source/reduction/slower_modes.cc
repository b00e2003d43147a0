// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/slower_modes.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::reduction
{
namespace
{
/// What @p mode moves the nodes of @p side away from the axis, 1/sqrt(kg), [ring][column].
std::vector<double> moved_away(const RoundFlexibility &side, const Vector &mode)
{
  std::vector<double> away(side.node.size());
  for (unsigned int i = 0; i < away.size(); ++i)
    {
      const double angle = 2. * dealii::numbers::PI * (i % side.n_columns) / side.n_columns;
      away[i] =
          std::cos(angle) * mode[3 * side.node[i]] + std::sin(angle) * mode[3 * side.node[i] + 1];
    }
  return away;
}

/// Adds to @p flexibility between @p side and @p other, [ring][ring of the other][columns between],
/// what @p mode deflects statically, times @p part of its 1/omega^2: the mean over all turns.
void add_deflection(const RoundFlexibility &side,
                    const RoundFlexibility &other,
                    const Vector           &mode,
                    const double            part,
                    std::vector<double>    &flexibility)
{
  const std::vector<double> here = moved_away(side, mode), there = moved_away(other, mode);
  const unsigned int        n = side.n_columns;
  for (unsigned int r = 0; r < side.n_rings(); ++r)
    for (unsigned int s = 0; s < other.n_rings(); ++s)
      for (unsigned int d = 0; d < n; ++d)
        {
          double sum = 0.;
          for (unsigned int c = 0; c < n; ++c)
            sum += here[r * n + c] * there[s * n + (c + d) % n];
          flexibility[(std::size_t(r) * other.n_rings() + s) * n + d] += part * sum / n;
        }
}
} // namespace

void add_mass(Basis &basis, const double cap)
{
  for (unsigned int m = 0; m < basis.size(); ++m)
    if (basis.omega[m] > cap)
      {
        basis.modes[m] *= cap / basis.omega[m];
        basis.omega[m] = cap;
        ++basis.n_slowed;
      }
}

void share_inertia(Basis &basis, const double cap)
{
  for (unsigned int m = 0; m < basis.n_natural; ++m)
    if (const double omega = basis.omega[m]; omega > cap)
      {
        const double kept = cap * cap / (omega * omega), part = (1. - kept) / (omega * omega);
        for (RoundFlexibility &side : basis.joints)
          {
            add_deflection(side, side, basis.modes[m], part, side.value);
            if (!side.to_bore.empty())
              add_deflection(side, basis.joints.front(), basis.modes[m], part, side.to_bore);
          }
        // phi phi^T / omega^2 times s: phi times s at the cap, since s = cap^2 / omega^2
        basis.modes[m] *= kept;
        basis.omega[m] = cap;
        ++basis.n_slowed;
      }
}

void slow_down(const mesh::Part &part, const BasisOptions &options, Basis &basis)
{
  const auto surfaces = part.mesh->get_boundary_ids();
  if (std::count(surfaces.begin(), surfaces.end(), mesh::roller_outside) == 0)
    {
      add_mass(basis, options.fastest_of_links);
      return;
    }
  const auto natural = basis.omega.begin() + basis.n_natural;
  if (std::none_of(basis.omega.begin(), natural, [&options](const double omega) {
        return omega > options.fastest_of_rollers;
      }))
    return;
  const std::vector<Load> loads = contact_loads(part, mesh::Nodes(part));
  std::vector<double>     whole; // compliances of the part, from those of the basis and its errors
  for (std::size_t i = 0; i < basis.errors.size(); ++i)
    whole.push_back(static_compliance(basis, loads[i].force) / (1. - basis.errors[i].relative));
  share_inertia(basis, options.fastest_of_rollers);
  for (std::size_t i = 0; i < whole.size(); ++i)
    basis.errors[i].relative = 1. - static_compliance(basis, loads[i].force) / whole[i];
}
} // namespace chaindrive::reduction
