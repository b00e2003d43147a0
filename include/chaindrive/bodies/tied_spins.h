// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_group.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace chaindrive
{
/// Lumped bodies that turn with the line between two others (World::Tied), such as bushes with
/// their link. They have no inertia of their own: with d the line and L its length the angular
/// velocity is z (d x (v2 - v1)) / L^2, and a moment M about z on such a body is the couple of the
/// forces -+ M (z x d) / L^2 on the two that the line joins, which does the same work.
class TiedSpins : public BodyGroup, public SurfaceGroup
{
public:
  void kick(World &world, double h) override;
  void drift(World &world, const Step &step) override;
  void finish(World &world, const Step &step) override;
  void place_surface(World & /*world*/, double /*earlier*/) override {}
  void gather_forces(World &world) override; ///< makes couples of the moments

private:
  void turn(World &world) const;
};
} // namespace chaindrive
