// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/system.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/scene/scene.h>

#include <map>
#include <memory>
#include <vector>

namespace chaindrive::observe
{
/// What reduced bodies in contacts without penalty deflect beside their modes: everywhere in them,
/// not only on the sides that touch, whose mean over all turns about the axis is what contacts know
/// of it (contact::JointFlexibility). It has no inertia and follows the forces of the instant.
/// Forces of other contacts, which have a penalty, deflect bodies by their modes alone.
class MasslessDeflections
{
public:
  MasslessDeflections(const scene::Scene &scene, const dynamics::System &system);

  /// By bodies of this rank on which such forces act: the displacement [m, world] of each node of
  /// the part. Collective.
  std::map<unsigned int, std::vector<dealii::Tensor<1, 3>>>
  now(const dynamics::System &system) const;

private:
  struct Part
  {
    std::unique_ptr<const reduction::FreePart> free;
    const reduction::Basis                    *basis;
  };

  std::map<unsigned int, Part> parts_; ///< by group of copies
};
} // namespace chaindrive::observe
