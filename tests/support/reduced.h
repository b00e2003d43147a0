// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Elastic bodies of a scene made reduced ones.

#include "scenes.h"

#include <chaindrive/bodies/reduced_bodies.h>
#include <chaindrive/mesh/mass.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/reduction/slower_modes.h>

namespace test
{
/// The reduced basis of @p part in @p scene.
inline reduction::Basis basis_of(const scene::Scene            &scene,
                                 const mesh::Part              &part,
                                 const reduction::BasisOptions &options = {})
{
  const mesh::Nodes         nodes(part);
  const reduction::FreePart free(
      part, nodes, element::ElasticPart(part, nodes, scene.material, scene.elements));
  reduction::Basis basis = make_basis(free, tractions(part, nodes, options.orders), options);
  if (!options.orders.in_joints)
    basis.joints = round_flexibilities(free, part, nodes, basis, !options.orders.on_teeth);
  slow_down(part, options, basis);
  return basis;
}

/// Makes all elastic bodies of @p scene but sprockets reduced ones.
inline void reduce(scene::Scene &scene, const reduction::BasisOptions &options = {})
{
  for (scene::Body &body : scene.bodies)
    if (body.motion == scene::Motion::elastic && body.kind != scene::Kind::sprocket)
      {
        const mesh::Part &part       = *scene.parts.at(body.part());
        const auto        properties = mesh::lumped_properties(part);
        body.motion                  = scene::Motion::reduced;
        body.mass                    = properties.mass;
        for (unsigned int d = 0; d < 3; ++d)
          body.inertia[d] = properties.inertia[d][d];
        auto &basis = scene.bases[body.part()];
        if (!basis)
          basis = std::make_shared<const reduction::Basis>(basis_of(scene, part, options));
      }
}

/// The group of the reduced bodies of a part, by its number in World::copies.
inline ReducedBodies &reduced_group(World &world, const unsigned int copies)
{
  for (const auto &group : world.groups.all())
    if (auto *found = dynamic_cast<ReducedBodies *>(group);
        found != nullptr && found->copies() == copies)
      return *found;
  throw std::logic_error("no such group");
}
} // namespace test
