// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/ledger.h>
#include <chaindrive/contact/geometry.h>
#include <chaindrive/contact/penalty.h>

namespace chaindrive::contact
{
/// update_touch() for a point by itself that books in @p ledger.
inline void update_point(const scene::ContactLaw    &law,
                         const double                gap,
                         const double                gap_rate,
                         const dealii::Tensor<1, 2> &slip_rate,
                         const double                dt,
                         TouchState                 &state,
                         Ledger                     &ledger)
{
  ContactEnergies<double> energies{ledger.contact, ledger.contact_damping, ledger.friction};
  const double            slip[2] = {slip_rate[0], slip_rate[1]};
  update_touch(
      law, PointApproach<double>{gap, gap_rate}, slip, dt, law.friction > 0., state, energies);
  ledger.contact         = energies.stored;
  ledger.contact_damping = energies.damping_loss;
  ledger.friction        = energies.friction_loss;
}

/// The force on a slave, N.
struct PointForce
{
  double               normal;     ///< along the surface's normal
  dealii::Tensor<1, 3> tangential; ///< by friction
  dealii::Tensor<1, 3> total;
};

/// The force on a slave that overlaps. Its material moves at @p relative [m/s] against the surface,
/// and slips at @p slip [m/s], which is the same where the surface does not turn under it.
inline PointForce penalty_force(const scene::ContactLaw    &law,
                                const Touch                &touch,
                                const dealii::Tensor<1, 3> &relative,
                                const dealii::Tensor<1, 3> &slip,
                                const double                dt,
                                TouchState                 &state,
                                Ledger                     &ledger)
{
  dealii::Tensor<1, 2> slip_rate;
  slip_rate[0] = slip * touch.along;
  slip_rate[1] = slip * touch.across;
  update_point(law, touch.gap, relative * touch.normal, slip_rate, dt, state, ledger);

  PointForce force;
  force.normal = state.normal;
  if (law.friction > 0.)
    force.tangential = state.tangential[0] * touch.along + state.tangential[1] * touch.across;
  force.total = state.normal * touch.normal + force.tangential;
  return force;
}

/// A slave that has just separated: the spring gives back what it held.
inline void
separate(const scene::ContactLaw &law, const double dt, TouchState &state, Ledger &ledger)
{
  if (state.penetration > 0.)
    update_point(law, 0., 0., dealii::Tensor<1, 2>(), dt, state, ledger);
}

/// A slave and a surface that overlap lose each other, past an edge: what their springs held is
/// lost.
inline void lose_contact(const scene::ContactLaw &law, TouchState &state, Ledger &ledger)
{
  ledger.contact_damping += 0.5 * law.stiffness * state.penetration * state.penetration;
  ledger.friction += 0.5 * law.tangential_stiffness *
                     (state.slip[0] * state.slip[0] + state.slip[1] * state.slip[1]);
  state = TouchState();
}
} // namespace chaindrive::contact
