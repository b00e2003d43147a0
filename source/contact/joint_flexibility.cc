// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/joint_flexibility.h>
#include <chaindrive/utilities/complementarity.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace chaindrive::contact
{
namespace
{
using dealii::numbers::PI;
using reduction::RoundFlexibility;

/// The @p values of a round side with @p n columns at those of one with @p m: the sum of the same
/// harmonics, as far as both have them.
std::vector<double>
with_columns(const std::vector<double> &values, const unsigned int n, const unsigned int m)
{
  if (n == m)
    return values;
  std::vector<double> result(values.size() / n * m, 0.);
  for (std::size_t i = 0; i < values.size() / n; ++i)
    for (unsigned int k = 0; k <= std::min(n, m) / 2; ++k)
      {
        double cosine = 0., sine = 0.;
        for (unsigned int d = 0; d < n; ++d)
          {
            cosine += values[i * n + d] * std::cos(2. * PI * k * d / n);
            sine += values[i * n + d] * std::sin(2. * PI * k * d / n);
          }
        const double factor = (k == 0 || 2 * k == n ? 1. : 2.) / n;
        for (unsigned int d = 0; d < m; ++d)
          result[i * m + d] += factor * (cosine * std::cos(2. * PI * k * d / m) +
                                         sine * std::sin(2. * PI * k * d / m));
      }
  return result;
}
} // namespace

JointFlexibility::JointFlexibility(const RoundFlexibility &bore, const RoundFlexibility &cylinder)
    : n_columns_(cylinder.n_columns)
{
  constexpr double tolerance = 1e-9; // m
  for (unsigned int r = 0; r < cylinder.n_rings(); ++r)
    {
      const double z = cylinder.rings[r];
      if (z < bore.rings.front() - tolerance || z > bore.rings.back() + tolerance)
        continue;
      unsigned int first = 0;
      while (first + 2 < bore.n_rings() && bore.rings[first + 1] < z)
        ++first;
      rings_.push_back(r);
      places_.push_back(
          {first,
           std::clamp(
               (z - bore.rings[first]) / (bore.rings[first + 1] - bore.rings[first]), 0., 1.)});
    }
  const std::vector<double> of_bore = with_columns(bore.value, bore.n_columns, n_columns_);
  for (unsigned int r = 0; r < n_rings(); ++r)
    for (unsigned int s = 0; s < n_rings(); ++s)
      for (unsigned int d = 0; d < n_columns_; ++d)
        {
          double sum = cylinder.at(rings_[r], rings_[s], d);
          for (const unsigned int i : {0u, 1u})
            for (const unsigned int j : {0u, 1u})
              {
                const double weight = (i == 0 ? 1. - places_[r].part : places_[r].part) *
                                      (j == 0 ? 1. - places_[s].part : places_[s].part);
                sum += weight *
                       of_bore[((places_[r].first + i) * bore.n_rings() + places_[s].first + j) *
                                   n_columns_ +
                               d];
              }
          sum_.push_back(sum);
        }
  if (rings_.empty())
    throw std::logic_error("JointFlexibility: the bore covers no ring of the cylinder");
  matrices_.resize(n_columns_ + 1);
}

const JointFlexibility::Matrix &JointFlexibility::of_columns(const unsigned int count) const
{
  std::unique_ptr<Matrix> &found = matrices_[count];
  if (!found)
    {
      found                = std::make_unique<Matrix>();
      const unsigned int m = n_rings();
      found->n             = count * m;
      found->stride        = ComplementaritySolver::padded(found->n);
      found->number.resize(std::size_t(found->n) * found->stride, 0.);
      for (unsigned int i = 0; i < found->n; ++i)
        for (unsigned int j = 0; j < found->n; ++j)
          {
            const unsigned int d = (j / m + n_columns_ - i / m) % n_columns_;
            found->number[std::size_t(i) * found->stride + j] =
                sum_[(std::size_t(i % m) * m + j % m) * n_columns_ + d];
          }
    }
  return *found;
}
} // namespace chaindrive::contact
