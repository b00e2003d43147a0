// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/ledger.h>
#include <chaindrive/contact/penalty.h>

#include <cstddef>
#include <vector>

namespace chaindrive::contact
{
/// A point that overlaps a surface by @p penetration [m], growing at @p rate [m/s], on a spring of
/// @p stiffness [N/m].
struct SpringPoint
{
  double stiffness, penetration, rate;
};

/// How far a surface deflects along its own normals, m, and how fast, m/s.
struct Deflection
{
  double depth = 0., rate = 0.;
};

/// A surface without mass on a spring of @p stiffness K [N/m] under the springs k_a of points that
/// overlap by d_a where it stands undeflected. Its deflection t has the least energy,
///
///   V = min over t of sum k_a <d_a - t>^2 / 2 + K t^2 / 2,   <x> = max(0, x),
///   K t = sum k_a <d_a - t>.
///
/// Since forces on the points, k_a <d_a - t> along their normals, are the derivatives of V, what
/// the springs hold is given back. The sum is piecewise linear and convex in t: Newton's method
/// from t = 0 deflects the surface ever farther, leaves out points that separate and ends with
/// the exact t when there are no more of these. The rate is that of t with the same points.
inline Deflection deflection_under(const double stiffness, const std::vector<SpringPoint> &points)
{
  Deflection  result;
  std::size_t n = 0, n_before = 0;
  do
    {
      double springs = stiffness, force = 0., rate = 0.;
      n_before = n;
      n        = 0;
      for (const SpringPoint &point : points)
        if (point.penetration > result.depth)
          {
            springs += point.stiffness;
            force += point.stiffness * point.penetration;
            rate += point.stiffness * point.rate;
            ++n;
          }
      result = {force / springs, rate / springs};
    }
  while (n != n_before);
  return result;
}

/// Books what the spring of a surface stores and what dashpots lose by its deflection: by the same
/// rule as for a point, with t for the penetration and the sum of the points' forces.
inline void book_deflection(const double      stiffness,
                            const TouchState &before,
                            const TouchState &now,
                            Ledger           &ledger)
{
  scene::ContactLaw law;
  law.stiffness = stiffness;
  ContactEnergies<double> energies{ledger.contact, ledger.contact_damping, ledger.friction};
  const double            way = now.penetration; // if the surface was not deflected before
  PointApproach<double>{-now.penetration, -way}.book(law, before, now, 1., energies);
  ledger.contact         = energies.stored;
  ledger.contact_damping = energies.damping_loss;
}
} // namespace chaindrive::contact
