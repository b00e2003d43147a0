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
      u.add(-part.mass_product(mode.vector, u), mode.vector);
}

/// What a load of unit compliance displaces beside natural modes, and its forces.
struct Attachment
{
  Vector force, displacement;
};

/// The loads of the class @p c of the part's symmetry; of those that differ by a factor only one.
std::vector<Attachment>
of_class(const FreePart &part, const std::vector<Attachment> &all, const unsigned int c)
{
  std::vector<Attachment> found;
  for (const Attachment &one : all)
    {
      Vector       force = part.part_of_class(one.force, c);
      const double size  = force.l2_norm();
      if (size < 1e-9 * one.force.l2_norm() ||
          std::any_of(found.begin(), found.end(), [&](const Attachment &other) {
            return std::abs(force * other.force) > (1. - 1e-9) * size * other.force.l2_norm();
          }))
        continue;
      found.push_back({force, part.part_of_class(one.displacement, c)});
    }
  return found;
}

/// The natural modes of the class @p c: of modes of equal frequency, which can be any of their
/// combinations, those combinations that have one.
std::vector<Mode>
of_class(const FreePart &part, const std::vector<Mode> &modes, const unsigned int c)
{
  const auto mass = [&part](const Vector &a, const Vector &b) { return part.mass_product(a, b); };
  const auto work = [&part](const Vector &a, const Vector &b) {
    return part.stiffness().matrix_scalar_product(a, b);
  };
  std::vector<Vector> parts;
  for (const Mode &mode : modes)
    if (Vector of_mode = part.part_of_class(mode.vector, c); mass(of_mode, of_mode) > 1e-6)
      parts.push_back(of_mode);
  if (parts.empty())
    return {};
  const Eigenpairs   of_mass = eigenpairs(products(parts, parts, mass));
  const unsigned int n       = static_cast<unsigned int>(parts.size());
  const auto         first   = std::upper_bound(of_mass.values.begin(), of_mass.values.end(), 1e-6);
  const unsigned int none    = static_cast<unsigned int>(first - of_mass.values.begin());
  dealii::FullMatrix<double> weights(n, n - none);
  for (unsigned int i = 0; i < weights.m(); ++i)
    for (unsigned int j = 0; j < weights.n(); ++j)
      weights(i, j) = of_mass.vectors(i, none + j) / std::sqrt(of_mass.values[none + j]);
  const std::vector<Vector> unit      = combinations(parts, weights);
  const Eigenpairs          stiffness = eigenpairs(products(unit, unit, work));
  const std::vector<Vector> vectors   = combinations(unit, stiffness.vectors);
  std::vector<Mode>         found;
  for (unsigned int i = 0; i < vectors.size(); ++i)
    found.push_back({std::sqrt(stiffness.values[i]), vectors[i]});
  return found;
}

/// Modes of unit stiffness from what the @p loads displace beside the natural @p modes.
std::vector<Vector> attachment_modes(const FreePart                &part,
                                     const std::vector<Mode>       &modes,
                                     const std::vector<Attachment> &loads,
                                     const double                   negligible)
{
  std::vector<Vector> forces, displacements;
  for (const Attachment &load : loads)
    {
      const double scale = 1. / std::sqrt(load.force * load.displacement); // to unit compliance
      displacements.push_back(load.displacement);
      remove(part, modes, displacements.back());
      displacements.back() *= scale;
      forces.push_back(load.force);
      forces.back() *= scale;
    }
  const Eigenpairs compliance = eigenpairs(
      products(forces, displacements, [](const Vector &f, const Vector &u) { return f * u; }));

  const unsigned int n = static_cast<unsigned int>(loads.size());
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

struct BasisVector
{
  double       omega;
  Vector       vector;
  unsigned int symmetry;
};

/// The Ritz vectors of K and M among @p stiff vectors of unit stiffness and of the class @p c.
void add_ritz_vectors(const FreePart            &part,
                      const std::vector<Vector> &stiff,
                      const double               cap,
                      const unsigned int         c,
                      std::vector<BasisVector>  &vectors)
{
  const Eigenpairs    mass = eigenpairs(products(
      stiff, stiff, [&part](const Vector &a, const Vector &b) { return part.mass_product(a, b); }));
  std::vector<Vector> ritz = combinations(stiff, mass.vectors);
  for (std::size_t i = ritz.size(); i-- > 0;) // values are 1/omega^2
    {
      const double omega = std::min(cap, 1. / std::sqrt(mass.values[i]));
      ritz[i] *= omega;
      vectors.push_back({omega, ritz[i], c});
    }
}

/// Adds @p vectors to the @p basis, the slowest first.
void add(std::vector<BasisVector> vectors, Basis &basis)
{
  std::stable_sort(vectors.begin(), vectors.end(), [](const BasisVector &a, const BasisVector &b) {
    return a.omega < b.omega;
  });
  for (const BasisVector &vector : vectors)
    {
      basis.omega.push_back(vector.omega);
      basis.modes.push_back(vector.vector);
      basis.symmetry.push_back(vector.symmetry);
    }
}
} // namespace

Basis make_basis(const FreePart            &part,
                 const std::vector<Vector> &tractions,
                 const BasisOptions        &options)
{
  const std::vector<Mode> modes = free_modes(part, options.modes_up_to);
  std::vector<Attachment> loads;
  loads.reserve(tractions.size());
  for (const Vector &traction : tractions)
    loads.push_back({traction, part.displacement(traction)});

  std::vector<BasisVector> natural, attached;
  for (unsigned int c = 0; c < part.symmetry().n_classes(); ++c)
    {
      const std::vector<Mode>       modes_here = of_class(part, modes, c);
      const std::vector<Attachment> loads_here = of_class(part, loads, c);
      for (const Mode &mode : modes_here)
        natural.push_back({mode.omega, mode.vector, c});
      if (!loads_here.empty())
        add_ritz_vectors(part,
                         attachment_modes(part, modes_here, loads_here, options.negligible),
                         options.cap,
                         c,
                         attached);
    }
  Basis basis;
  basis.n_natural   = static_cast<unsigned int>(natural.size());
  basis.reflections = part.symmetry().axis;
  add(natural, basis);
  add(attached, basis);
  return basis;
}

std::vector<Vector>
massless_displacements(const FreePart &part, const Basis &basis, const std::vector<Vector> &forces)
{
  std::vector<Vector> u = part.displacements(forces);
  for (std::size_t f = 0; f < u.size(); ++f)
    for (unsigned int i = 0; i < basis.size(); ++i)
      u[f].add(-(forces[f] * basis.modes[i]) / (basis.omega[i] * basis.omega[i]), basis.modes[i]);
  return u;
}

double static_compliance(const Basis &basis, const Vector &force)
{
  double compliance = 0.;
  for (unsigned int i = 0; i < basis.size(); ++i)
    compliance += std::pow(force * basis.modes[i] / basis.omega[i], 2);
  for (const RoundFlexibility &side : basis.joints)
    compliance += side.compliance(force);
  return compliance;
}

double static_error(const FreePart &part, const Basis &basis, const Vector &force)
{
  return 1. - static_compliance(basis, force) / (force * part.displacement(force));
}
} // namespace chaindrive::reduction
