// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_group.h>

namespace chaindrive
{
/// Rigid bodies, 6 degrees of freedom, and lumped ones, 3 translations and the spin of a ring.
///
/// Newmark's method with beta = 0 and gamma = 1/2 (central differences). Rotations follow the same
/// pattern for the angular momentum L; the orientation advances by the rotation dt w with w from L
/// at half the step (the explicit midpoint rule), so that L is constant to round-off when no moment
/// acts (doc/theory.md, section 5).
///
/// Bodies of other groups have no inverse mass here: between two bookings by their own group their
/// centres of mass coast.
class RigidBodies : public BodyGroup
{
public:
  void   kick(World &world, double h) override;
  void   drift(World &world, const Step &step) override;
  void   finish(World &world, const Step &step) override;
  double kinetic_energy(const World &world) const override;
};
} // namespace chaindrive
