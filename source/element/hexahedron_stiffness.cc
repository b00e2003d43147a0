// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/hexahedron_stiffness.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::element
{
using dealii::Tensor;

dealii::FullMatrix<double> stiffness(const std::array<mesh::GaussPoint, 8> &points,
                                     const Material                        &material,
                                     const bool                             enhanced)
{
  const double lambda = material.lambda(), mu = material.mu();

  // The incompatible modes are three more functions beside the eight shape functions.
  const unsigned int         n = enhanced ? 11 : 8;
  dealii::FullMatrix<double> k(3 * n, 3 * n);
  for (const mesh::GaussPoint &point : points)
    {
      std::vector<Tensor<1, 3>> g(point.gradient.begin(), point.gradient.end());
      g.insert(g.end(), point.incompatible.begin(), point.incompatible.end());
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              k(3 * a + i, 3 * b + j) +=
                  point.volume * (lambda * g[a][i] * g[b][j] + mu * g[a][j] * g[b][i] +
                                  (i == j ? mu * (g[a] * g[b]) : 0.));
    }
  if (!enhanced)
    return k;

  // k_uu - k_ua k_aa^-1 k_au
  dealii::FullMatrix<double> result(24, 24), inner(9, 9), inverse(9, 9), coupling(24, 9);
  for (unsigned int r = 0; r < 24; ++r)
    for (unsigned int c = 0; c < 24; ++c)
      result(r, c) = k(r, c);
  for (unsigned int r = 0; r < 24; ++r)
    for (unsigned int c = 0; c < 9; ++c)
      coupling(r, c) = k(r, 24 + c);
  for (unsigned int r = 0; r < 9; ++r)
    for (unsigned int c = 0; c < 9; ++c)
      inner(r, c) = k(24 + r, 24 + c);
  inverse.invert(inner);
  inverse *= -1.;
  result.triple_product(inverse, coupling, coupling, false, true);
  return result;
}

namespace
{
/// Whose eigenvalues are the squares of the natural frequencies; symmetric.
dealii::FullMatrix<double> scaled_by(const std::array<double, 8>      &masses,
                                     const dealii::FullMatrix<double> &stiffness)
{
  dealii::FullMatrix<double> scaled(24, 24);
  for (unsigned int r = 0; r < 24; ++r)
    for (unsigned int c = 0; c < 24; ++c)
      scaled(r, c) = stiffness(r, c) / std::sqrt(masses[r / 3] * masses[c / 3]);
  return scaled;
}
} // namespace

std::vector<double> natural_frequencies(const dealii::FullMatrix<double> &stiffness,
                                        const std::array<double, 8>      &masses)
{
  const dealii::FullMatrix<double> scaled = scaled_by(masses, stiffness);

  std::vector<double> frequencies;
  for (const double value : eigenpairs(scaled).values)
    frequencies.push_back(std::sqrt(std::max(0., value)));
  return frequencies;
}

double largest_frequency(const mesh::Corners &corners,
                         const Material      &material,
                         const double         density,
                         const double         known)
{
  const auto points = mesh::gauss_points(corners);
  const auto masses = mesh::lumped_masses(points, density);
  const auto matrix = stiffness(points, material, false);
  if (known > 0.)
    { // no eigenvalue is above the fourth root of the sum of the fourth powers of all
      const dealii::FullMatrix<double> scaled = scaled_by(masses, matrix);
      dealii::FullMatrix<double>       square(24, 24);
      scaled.mmult(square, scaled);
      if (std::sqrt(std::sqrt(square.frobenius_norm())) < known)
        return 0.;
    }
  return natural_frequencies(matrix, masses).back();
}
} // namespace chaindrive::element
