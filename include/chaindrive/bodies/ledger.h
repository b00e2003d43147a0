// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace chaindrive
{
/// The running energy balance, in J. Everything that stores, feeds or takes energy has its own
/// line:
///
///   imbalance = stored - stored at the start + lost - drive work + resisting work
///
/// and is zero but for the error of the time integration. Stored terms belong to the present
/// instant; losses and works are sums since the start, by the trapezoidal rule over the steps.
/// The driver's own kinetic energy is left out, and so is the torque that accelerates it. Of a
/// driver with an elastic rim that holds for the hub: the rim's energies count, and the drive work
/// is that of the rim and the chain together.
struct Ledger
{
  // stored
  double kinetic   = 0.; ///< of all bodies that move freely
  double potential = 0.; ///< of gravity, zero at the start
  double bar       = 0.; ///< strain energy of bars
  double strain    = 0.; ///< of elastic bodies
  double hourglass = 0.; ///< of elastic bodies: stabilisation that is no physical strain
  double contact   = 0.; ///< penalty springs, normal and tangential
  double spring    = 0.; ///< of force elements other than bars
  // lost
  double friction        = 0.; ///< sliding, and tangential damping while sticking
  double contact_damping = 0.; ///< normal damping in contacts
  double chain_damping   = 0.; ///< dashpots of bars
  double drag            = 0.; ///< drag proportional to mass and velocity
  double spring_damping  = 0.; ///< dashpots of force elements other than bars
  // fed and taken by the two hubs
  double drive_work     = 0.; ///< of the prescribed hub on the chain and its rim
  double resisting_work = 0.; ///< of the driven hub against the load torque

  double initial = 0.; ///< stored() when the run began

  double stored() const
  {
    return kinetic + potential + bar + strain + hourglass + contact + spring;
  }
  double lost() const { return friction + contact_damping + chain_damping + drag + spring_damping; }
  double imbalance() const { return stored() - initial + lost() - drive_work + resisting_work; }

  /// All but the work of the hubs: what bodies, contacts and loads add, each for itself.
  static constexpr double Ledger::*added[] = {&Ledger::kinetic,
                                              &Ledger::potential,
                                              &Ledger::bar,
                                              &Ledger::strain,
                                              &Ledger::hourglass,
                                              &Ledger::contact,
                                              &Ledger::friction,
                                              &Ledger::contact_damping,
                                              &Ledger::chain_damping,
                                              &Ledger::drag,
                                              &Ledger::spring,
                                              &Ledger::spring_damping};

  /// Stored energy is summed anew by whoever stores it, at every evaluation of the forces.
  void clear_stored() { kinetic = potential = bar = strain = hourglass = contact = spring = 0.; }
};
} // namespace chaindrive
