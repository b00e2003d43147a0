// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_group.h>

namespace chaindrive
{
/// Nodes on those sides of rigid bodies of one kind that nodes of elastic ones touch: a group with
/// no modes. They follow the frames of their bodies, and hand the moments of contact on to them.
class RigidSurfaceNodes : public BodyGroup, public SurfaceGroup
{
public:
  /// Nodes of one side of a rigid body.
  struct Side
  {
    unsigned int              body, copy;
    std::vector<unsigned int> nodes;
  };

  /// @p sides of bodies that are @p world's copies number @p group.
  RigidSurfaceNodes(unsigned int group, std::vector<Side> sides);

  void place_surface(World &world, double earlier) override;

  /// Adds the moments of the forces on these nodes, which become zero, to those on their bodies.
  /// The resultant forces are the contact's to add.
  void gather_forces(World &world) override;

private:
  unsigned int      group_; ///< in World::copies
  std::vector<Side> sides_;
};
} // namespace chaindrive
