// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/roller_ring.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>

namespace chaindrive::drive
{
namespace
{
using Terms = std::array<double, 4>;

/// What a term of the stress function, the radius to the power of 2, -2, 4 or 0 times cos 2 angle,
/// has of something at a radius, for all four. Lengths are in units of the outer radius.
Terms radial_stress(const double r)
{
  const double s = 1. / (r * r);
  return {{-2., -6. * s * s, 0., -4. * s}}; // of cos
}

Terms shear_stress(const double r)
{
  const double s = 1. / (r * r);
  return {{2., -6. * s * s, 6. / s, -2. * s}}; // of sin
}

/// Twice the shear modulus times the displacement, with Kolosov's constant @p kappa.
Terms radial_displacement(const double r, const double kappa)
{
  return {{-2. * r, 2. / (r * r * r), (kappa - 3.) * r * r * r, (kappa + 1.) / r}}; // of cos
}

Terms tangential_displacement(const double r, const double kappa)
{
  return {{2. * r, 2. / (r * r * r), (kappa + 3.) * r * r * r, -(kappa - 1.) / r}}; // of sin
}

double sum_of(const Terms &terms, const dealii::Vector<double> &factors)
{
  double sum = 0.;
  for (unsigned int i = 0; i < 4; ++i)
    sum += terms[i] * factors[i];
  return sum;
}
} // namespace

RollerRing
oval_of_ring(const double inner, const double outer, const double length, const Material &steel)
{
  const double ratio = inner / outer, kappa = 3. - 4. * steel.poissons_ratio;
  // unit tension cos 2 angle on the outside, nothing else
  dealii::FullMatrix<double> matrix(4, 4);
  const Terms                rows[4] = {
                     radial_stress(1.), shear_stress(1.), radial_stress(ratio), shear_stress(ratio)};
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      matrix(i, j) = rows[i][j];
  dealii::Vector<double> tension(4), factors(4);
  tension[0] = 1.;
  matrix.gauss_jordan();
  matrix.vmult(factors, tension);

  const double per_shear = outer / (2. * steel.mu()); // m per Pa
  const double moved     = per_shear * sum_of(radial_displacement(1., kappa), factors);
  const double pi        = dealii::numbers::PI;
  RollerRing   ring{};
  // a force F at one place is the tension F / (pi outer length) cos 2 angle, and more waves
  ring.stiffness = pi * outer * length / moved;
  ring.bore      = per_shear * sum_of(radial_displacement(ratio, kappa), factors) / moved;
  const dealii::QGauss<1> rule(8);
  for (unsigned int q = 0; q < rule.size(); ++q)
    {
      const double r = ratio + (1. - ratio) * rule.point(q)[0];
      const double u = per_shear * sum_of(radial_displacement(r, kappa), factors) / moved,
                   v = per_shear * sum_of(tangential_displacement(r, kappa), factors) / moved;
      ring.mass += rule.weight(q) * (1. - ratio) * steel.density * length * outer * outer * pi * r *
                   (u * u + v * v);
    }
  return ring;
}

RollerRing roller_ring(const ChainDimensions &chain, const Material &steel)
{
  return oval_of_ring(
      0.5 * chain.roller_bore, 0.5 * chain.roller_diameter, chain.roller_length, steel);
}
} // namespace chaindrive::drive
