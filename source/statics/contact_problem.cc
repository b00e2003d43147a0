// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/statics/contact_problem.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::statics
{
namespace
{
constexpr unsigned int n_strips = 8; ///< of a patch

/// pi E* times the displacement at (@p x, @p y) of a half-space by a unit pressure on a rectangle
/// of half widths @p a and @p b about the origin, m (Love 1929).
double love(const double x, const double y, const double a, const double b)
{
  const auto part = [](const double u, const double v) {
    return u == 0. ? 0. : u * std::asinh(v / std::abs(u));
  };
  return part(x + a, y + b) - part(x + a, y - b) + part(y + b, x + a) - part(y + b, x - a) -
         part(x - a, y + b) + part(x - a, y - b) - part(y - b, x + a) + part(y - b, x - a);
}

/// Displacements of strips (number: strip * n_rings + ring) of both bodies under pressures on
/// strips and on their mirror images, their means over patches left out, m/Pa.
dealii::FullMatrix<double> within_patches(const PatchGrid &grid, const Material &material)
{
  const unsigned int         m = grid.n_rings(), n = grid.n_angles * n_strips * m;
  const double               h      = grid.radius * grid.width / n_strips;
  const double               factor = 2. / (dealii::numbers::PI * material.plane_modulus());
  dealii::FullMatrix<double> u(n, n);
  for (unsigned int s = 0; s < m; ++s)
    for (unsigned int t = 0; t < m; ++t)
      {
        const double z = 0.5 * (grid.z[s] + grid.z[s + 1]), w = 0.5 * (grid.z[t] + grid.z[t + 1]),
                     b = 0.5 * (grid.z[t + 1] - grid.z[t]);
        // by the distance between strips
        std::vector<double> at(2 * grid.n_angles * n_strips);
        for (unsigned int d = 0; d < at.size(); ++d)
          at[d] = factor * (love(h * d, z - w, 0.5 * h, b) + love(h * d, z + w, 0.5 * h, b));
        for (unsigned int i = 0; i < grid.n_angles * n_strips; ++i)
          for (unsigned int j = 0; j < grid.n_angles * n_strips; ++j)
            u(i * m + s, j * m + t) = at[i < j ? j - i : i - j] + at[i + j + 1];
        for (unsigned int I = 0; I < grid.n_angles; ++I)
          for (unsigned int J = 0; J < grid.n_angles; ++J)
            {
              double mean = 0.;
              for (unsigned int i = I * n_strips; i < (I + 1) * n_strips; ++i)
                for (unsigned int j = J * n_strips; j < (J + 1) * n_strips; ++j)
                  mean += u(i * m + s, j * m + t) / (n_strips * n_strips);
              for (unsigned int i = I * n_strips; i < (I + 1) * n_strips; ++i)
                for (unsigned int j = J * n_strips; j < (J + 1) * n_strips; ++j)
                  u(i * m + s, j * m + t) -= mean;
            }
      }
  return u;
}
} // namespace

unsigned int PatchGrid::number(const double angle, const double height) const
{
  const double a = std::abs(angle) / width, h = std::abs(height);
  if (!(a < n_angles) || h >= z.back())
    return none;
  const auto ring = std::upper_bound(z.begin(), z.end(), h) - z.begin() - 1;
  return static_cast<unsigned int>(a) * n_rings() + static_cast<unsigned int>(ring);
}

ContactProblem::ContactProblem(std::vector<Interface>     interfaces,
                               std::vector<CompliantPart> parts,
                               const Material            &material)
    : interfaces_(std::move(interfaces)), parts_(std::move(parts))
{
  std::vector<unsigned int> ring;
  unsigned int              first = 0;
  for (unsigned int k = 0; k < interfaces_.size(); ++k)
    {
      const PatchGrid &grid = interfaces_[k].grid;
      for (unsigned int i = 0; i < grid.n_angles * n_strips; ++i)
        for (unsigned int s = 0; s < grid.n_rings(); ++s)
          {
            const double angle = (i + 0.5) * grid.width / n_strips;
            interface_.push_back(k);
            patch_.push_back(first + i / n_strips * grid.n_rings() + s);
            strip_.push_back(i);
            ring.push_back(s);
            gap_.push_back(interfaces_[k].gap(angle));
            along_.push_back(std::cos(angle));
            share_.push_back(4. * along_.back() * grid.area(s) / n_strips);
          }
      first += grid.n();
    }
  Flexibility flexibility(first, first);
  for (const CompliantPart &part : parts_)
    {
      AssertThrow(part.first + part.values.m() <= first, dealii::ExcInternalError());
      for (unsigned int i = 0; i < part.values.m(); ++i)
        for (unsigned int j = 0; j < part.values.n(); ++j)
          flexibility(part.first + i, part.first + j) += part.values(i, j);
    }
  const unsigned int n = static_cast<unsigned int>(gap_.size());
  fine_.reinit(n, n);
  std::vector<dealii::FullMatrix<double>> within;
  for (const Interface &interface : interfaces_)
    within.push_back(within_patches(interface.grid, material));
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      {
        fine_(i, j)          = flexibility(patch_[i], patch_[j]) / n_strips;
        const unsigned int k = interface_[i];
        if (interface_[j] == k)
          {
            const unsigned int m = interfaces_[k].grid.n_rings();
            fine_(i, j) += within[k](strip_[i] * m + ring[i], strip_[j] * m + ring[j]);
          }
      }
}

ContactSolution ContactProblem::at(const double force) const
{
  const unsigned int n = static_cast<unsigned int>(gap_.size()),
                     m = static_cast<unsigned int>(interfaces_.size());
  std::vector<bool>   active(n, true);
  std::vector<double> pressure(n, 0.), approach(m, 0.);

  for (unsigned int iteration = 0;; ++iteration)
    {
      if (iteration > 100)
        throw RunError("The contact of two parts of the chain was not found.");
      std::vector<unsigned int> on;
      for (unsigned int i = 0; i < n; ++i)
        if (active[i])
          on.push_back(i);
      const unsigned int               a = static_cast<unsigned int>(on.size());
      dealii::LAPACKFullMatrix<double> system(a + m, a + m);
      dealii::Vector<double>           x(a + m);
      // pressures and approaches are scaled to like sizes
      const double modulus = 1e12;
      for (unsigned int i = 0; i < a; ++i)
        {
          for (unsigned int j = 0; j < a; ++j)
            system(i, j) = modulus * fine_(on[i], on[j]);
          for (unsigned int k = 0; k < m; ++k)
            {
              const bool mine  = interface_[on[i]] == k;
              system(i, a + k) = mine ? -along_[on[i]] : 0.;
              system(a + k, i) = mine ? modulus * share_[on[i]] / force : 0.;
            }
          x[i] = -gap_[on[i]];
        }
      for (unsigned int k = 0; k < m; ++k)
        {
          for (unsigned int l = 0; l < m; ++l)
            system(a + k, a + l) = 0.;
          x[a + k] = 1.;
        }
      system.compute_lu_factorization();
      system.solve(x);
      std::fill(pressure.begin(), pressure.end(), 0.);
      for (unsigned int i = 0; i < a; ++i)
        pressure[on[i]] = modulus * x[i];
      for (unsigned int k = 0; k < m; ++k)
        approach[k] = x[a + k];

      bool changed = false;
      for (unsigned int i = 0; i < n; ++i)
        if (active[i])
          {
            if (pressure[i] < 0.)
              {
                active[i] = false;
                changed   = true;
              }
          }
        else
          {
            double gap = gap_[i] - along_[i] * approach[interface_[i]];
            for (const unsigned int j : on)
              gap += fine_(i, j) * pressure[j];
            if (gap < -1e-13)
              {
                active[i] = true;
                changed   = true;
              }
          }
      if (!changed)
        break;
    }

  ContactSolution result;
  result.approach        = approach;
  result.reaches_the_end = false;
  unsigned int first     = 0;
  for (unsigned int k = 0; k < m; ++k)
    {
      const PatchGrid &grid = interfaces_[k].grid;
      result.pressure.emplace_back(grid.n(), 0.);
      result.on_line.push_back(0.);
      result.half_angle.push_back(0.);
      for (unsigned int i = 0; i < n; ++i)
        if (interface_[i] == k)
          {
            result.pressure[k][patch_[i] - first] += pressure[i] / n_strips;
            if (strip_[i] == 0)
              result.on_line[k] = std::max(result.on_line[k], pressure[i]);
            if (pressure[i] > 0.)
              result.half_angle[k] = std::max(result.half_angle[k],
                                              std::acos(along_[i]) + 0.5 * grid.width / n_strips);
            if (pressure[i] > 0. && patch_[i] - first >= grid.n() - grid.n_rings())
              result.reaches_the_end = true;
          }
      first += grid.n();
    }

  // the work of the pressure on a part over that of the force
  std::vector<double> mean(first, 0.), weight(first, 0.);
  for (unsigned int i = 0; i < n; ++i)
    mean[patch_[i]] += pressure[i] / n_strips;
  for (unsigned int i = 0; i < n; ++i)
    weight[patch_[i]] += share_[i] / along_[i] / force;
  for (const CompliantPart &part : parts_)
    {
      double way = 0.;
      for (unsigned int i = 0; i < part.values.m(); ++i)
        for (unsigned int j = 0; j < part.values.n(); ++j)
          way += weight[part.first + i] * mean[part.first + i] * part.values(i, j) *
                 mean[part.first + j];
      result.given_way.push_back(way);
    }
  return result;
}
} // namespace chaindrive::statics
