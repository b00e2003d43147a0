// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/ledger.h>
#include <chaindrive/scene/interface.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
/// What one contact point remembers from step to step.
struct TouchState
{
  double               overlap = 0.; ///< penetration of the last evaluation, m; 0 when apart
  double               normal  = 0.; ///< force along the master's normal, N, never negative
  dealii::Tensor<1, 2> slip;         ///< elastic part of the slip in the master's tangents, m
  dealii::Tensor<1, 2> tangential;   ///< force on the slave along the master's tangents, N
};

/// Penalty force with damping and Coulomb friction of one point at one instant.
///
///   N = max(0, k d - c g'),  d = max(0, -g)            linear spring and dashpot (Kelvin-Voigt)
///   |k_t s| <= mu N                                   return mapping of the elastic slip s
///   T = - k_t s - c_t s',    |T| <= mu N              and then of the force: the dashpot takes
///                                                     what the spring leaves of the limit
///
/// With the return mapping a contact below the limit is an elastic spring that keeps its origin: it
/// sticks and does not creep (Giannakopoulos 1989; Wriggers, Computational Contact Mechanics, 5.2).
/// Nothing but slip loads the spring. If T were mapped back alone and s = -T / k_t, it would take
/// over the dashpot's share, with energy that no work has put in. The dashpot's part never drives:
/// with the projection P onto the disc of radius mu N, which holds -k_t s, and T = P(-k_t s - c_t
/// s'), it is (T + k_t s) . s' <= 0.
/// Stored energy and losses go to the ledger by the trapezoidal rule over the step.
///
/// @p gap g [m], negative when the surfaces overlap; @p gap_rate g' [m/s]; @p slip_rate velocity of
/// the slave's material relative to the master's along the two tangents [m/s]; @p dt the time since
/// the last evaluation [s]. Returns whether there is a force.
inline bool update_touch(const scene::ContactLaw    &law,
                         const double                gap,
                         const double                gap_rate,
                         const dealii::Tensor<1, 2> &slip_rate,
                         const double                dt,
                         TouchState                 &touch,
                         Ledger                     &ledger)
{
  const TouchState before  = touch;
  const double     overlap = std::max(0., -gap);

  touch.overlap = overlap;
  touch.normal = overlap > 0. ? std::max(0., law.stiffness * overlap - law.damping * gap_rate) : 0.;

  // The work of the normal force on both bodies is stored in the spring or lost in the dashpot.
  const double spring_before = 0.5 * law.stiffness * before.overlap * before.overlap;
  const double spring        = 0.5 * law.stiffness * overlap * overlap;
  ledger.contact += spring;
  ledger.contact_damping +=
      0.5 * (before.normal + touch.normal) * (overlap - before.overlap) - (spring - spring_before);

  if (law.friction > 0.)
    {
      const dealii::Tensor<1, 2> increment    = dt * slip_rate;
      const double               limit        = law.friction * touch.normal;
      const auto                 within_limit = [limit](const double size) {
        return size > limit ? limit / size : 1.;
      };
      touch.slip = before.slip + increment;
      touch.slip *= within_limit(law.tangential_stiffness * touch.slip.norm());
      touch.tangential =
          -law.tangential_stiffness * touch.slip - law.tangential_damping * slip_rate;
      touch.tangential *= within_limit(touch.tangential.norm());

      const double stored_before = 0.5 * law.tangential_stiffness * before.slip.norm_square();
      const double stored        = 0.5 * law.tangential_stiffness * touch.slip.norm_square();
      ledger.contact += stored;
      ledger.friction -=
          0.5 * ((before.tangential + touch.tangential) * increment) + (stored - stored_before);
    }
  return touch.normal > 0.;
}

/// Two surfaces that overlap lose each other, past an edge: what their springs held is lost.
inline void lose_touch(const scene::ContactLaw &law, TouchState &touch, Ledger &ledger)
{
  ledger.contact_damping += 0.5 * law.stiffness * touch.overlap * touch.overlap;
  ledger.friction += 0.5 * law.tangential_stiffness * touch.slip.norm_square();
  touch = TouchState();
}
} // namespace chaindrive::contact
