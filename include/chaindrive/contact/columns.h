// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/numbers.h>

#include <array>
#include <cmath>

namespace chaindrive::contact
{
/// Weights of the cubic polynomial through four equidistant points, at the part @p t of the way
/// from the second to the third one.
inline std::array<double, 4> cubic_weights(const double t)
{
  return {{-t * (t - 1.) * (t - 2.) / 6.,
           (t + 1.) * (t - 1.) * (t - 2.) / 2.,
           -(t + 1.) * t * (t - 2.) / 2.,
           (t + 1.) * t * (t - 1.) / 6.}};
}

/// Their derivatives.
inline std::array<double, 4> cubic_slopes(const double t)
{
  return {{-(3. * t * t - 6. * t + 2.) / 6.,
           (3. * t * t - 4. * t - 1.) / 2.,
           -(3. * t * t - 2. * t - 2.) / 2.,
           (3. * t * t - 1.) / 6.}};
}

/// Four columns of @p n about an @p angle [rad], and how much each counts there.
struct Columns
{
  Columns(const double angle, const unsigned int n)
  {
    const double column = angle * n / (2. * dealii::numbers::PI), before = std::floor(column);
    weight = cubic_weights(column - before);
    slope  = cubic_slopes(column - before);
    for (double &per_column : slope)
      per_column *= n / (2. * dealii::numbers::PI);
    for (unsigned int k = 0; k < number.size(); ++k)
      number[k] =
          static_cast<unsigned int>(static_cast<int>(before) + static_cast<int>(k + n) - 1) % n;
  }

  std::array<unsigned int, 4> number;
  std::array<double, 4>       weight, slope; ///< slope: by how much more per radian
};
} // namespace chaindrive::contact
