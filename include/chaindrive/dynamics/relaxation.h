// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/system.h>

#include <optional>

namespace chaindrive::dynamics
{
/// The strain of elastic bodies that are placed without strain where their surfaces overlap, in
/// balance with the forces that they then exert on each other. Links keep their centres of mass and
/// directions (inertia relief: what moves a body as a whole strains nothing), but those of a
/// running chain out of line lean across its plane as their pins ask; rims keep their hubs, rigid
/// bodies their places; a roller finds its own between tooth and bush. So do reduced ones, whose
/// modes relax.
///
/// The drive, at rest, unloaded and without friction, is a System of its own: internal and contact
/// forces are those of the run. Dynamic relaxation with kinetic damping (Barnes, Int. J. Space
/// Structures 14, 1999, 89) moves it: whenever the kinetic energy has passed a maximum, all comes
/// to a stop. The first step after a stop goes down the gradient of the energy, for which the step
/// must be below sqrt(2) over the largest frequency; modes, which stop a step later, need a
/// shorter one. No node is let move faster than contacts
/// foresee, so that deep penetrations are pressed out and no contact is missed.
class Relaxation
{
public:
  /// Collective. It ends when the stored energy changes by less than the share @p change of itself
  /// while waves run along a link five times, of 5e-5 where links lean, if that is less. RunError
  /// if no balance is found. @p known: the critical time step [s] of a scene that differs from this
  /// one in places of bodies only.
  Relaxation(const scene::Scene   &scene,
             MPI_Comm              comm,
             double                change = 2e-3,
             std::optional<double> known  = {});

  double critical_time_step() const { return critical_time_step_; } ///< at rest, s

  /// Strains the bodies of @p world, which is made of the same scene and distributed alike; nodes
  /// move as their bodies do at the start.
  void strain(World &world) const;

  /// What joints with elastic bodies carry, N; 0 for other joints.
  struct JointForces
  {
    std::vector<double> pin;  ///< pins in bushes; negative where they push
    std::vector<double> seat; ///< rollers on teeth
  };

  /// The same on all ranks. Collective.
  JointForces joint_forces();

private:
  const scene::Scene &scene_;
  System              system_;
  double              critical_time_step_;
};
} // namespace chaindrive::dynamics
