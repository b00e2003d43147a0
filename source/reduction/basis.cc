// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/basis.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::reduction
{
namespace
{
/// The sums of @p vectors weighted by the columns of @p weights.
std::vector<Vector> combinations(const std::vector<Vector>        &vectors,
                                 const dealii::FullMatrix<double> &weights)
{
  std::vector<Vector> sums(weights.n(), Vector(vectors.empty() ? 0 : vectors[0].size()));
  for (unsigned int i = 0; i < weights.m(); ++i)
    for (unsigned int j = 0; j < weights.n(); ++j)
      sums[j].add(weights(i, j), vectors[i]);
  return sums;
}

/// The product of each of @p a with each of @p b, made symmetric.
template <typename ScalarProduct>
dealii::FullMatrix<double>
products(const std::vector<Vector> &a, const std::vector<Vector> &b, const ScalarProduct &product)
{
  const std::size_t          n = a.size();
  dealii::FullMatrix<double> matrix(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      {
        const double value = 0.5 * product(a[i], b[j]);
        matrix(i, j) += value;
        matrix(j, i) += value;
      }
  return matrix;
}

/// What remains of @p u beside the natural @p modes.
void remove(const FreePart &part, const std::vector<Mode> &modes, Vector &u)
{
  for (unsigned int pass = 0; pass < 2; ++pass)
    for (const Mode &mode : modes)
      u.add(-part.mass_product(mode.shape, u), mode.shape);
}

/// Shapes of unit stiffness from what @p pressures displace beside the natural @p modes.
std::vector<Vector> attachments(const FreePart            &part,
                                const std::vector<Mode>   &modes,
                                const std::vector<Vector> &pressures,
                                const double               negligible)
{
  std::vector<Vector> forces, displacements;
  for (const Vector &pressure : pressures)
    {
      Vector       u     = part.displacement(pressure);
      const double scale = 1. / std::sqrt(pressure * u); // to unit compliance
      remove(part, modes, u);
      u *= scale;
      displacements.push_back(u);
      forces.push_back(pressure);
      forces.back() *= scale;
    }
  const Eigenpairs compliance = eigenpairs(
      products(forces, displacements, [](const Vector &f, const Vector &u) { return f * u; }));

  const unsigned int n = static_cast<unsigned int>(pressures.size());
  const auto         first =
      std::upper_bound(compliance.values.begin(), compliance.values.end(), negligible);
  const unsigned int n_left_out = static_cast<unsigned int>(first - compliance.values.begin());
  dealii::FullMatrix<double> weights(n, n - n_left_out);
  for (unsigned int i = 0; i < weights.m(); ++i)
    for (unsigned int j = 0; j < weights.n(); ++j)
      weights(i, j) =
          compliance.vectors(i, n_left_out + j) / std::sqrt(compliance.values[n_left_out + j]);
  return combinations(displacements, weights);
}
} // namespace

Basis make_basis(const FreePart            &part,
                 const std::vector<Vector> &pressures,
                 const BasisOptions        &options)
{
  const std::vector<Mode> modes = free_modes(part, options.modes_up_to);
  Basis                   basis;
  basis.n_natural = static_cast<unsigned int>(modes.size());
  for (const Mode &mode : modes)
    {
      basis.omega.push_back(mode.omega);
      basis.shape.push_back(mode.shape);
    }
  if (pressures.empty())
    return basis;

  const std::vector<Vector> stiff = attachments(part, modes, pressures, options.negligible);
  const Eigenpairs          mass  = eigenpairs(products(
      stiff, stiff, [&part](const Vector &a, const Vector &b) { return part.mass_product(a, b); }));
  std::vector<Vector>       ritz  = combinations(stiff, mass.vectors);
  for (std::size_t i = ritz.size(); i-- > 0;) // values are 1/omega^2
    {
      basis.omega.push_back(std::min(options.cap, 1. / std::sqrt(mass.values[i])));
      ritz[i] *= basis.omega.back();
      basis.shape.push_back(ritz[i]);
    }
  return basis;
}

double static_error(const FreePart &part, const Basis &basis, const Vector &force)
{
  double compliance = 0.;
  for (unsigned int i = 0; i < basis.size(); ++i)
    compliance += std::pow(force * basis.shape[i] / basis.omega[i], 2);
  return 1. - compliance / (force * part.displacement(force));
}
} // namespace chaindrive::reduction
