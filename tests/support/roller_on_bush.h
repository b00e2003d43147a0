// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// A roller of elements or modes before a rigid tooth, and a link one of whose bushes is in it.

#include "reduced.h"
#include "tooth.h"

#include <utility>

namespace test
{
/// Gives the scene meshes of the @p chain's rollers and inner links.
inline void mesh_roller_and_link(scene::Scene                 &scene,
                                 const drive::ChainDimensions &chain,
                                 const mesh::RollerGrid       &roller,
                                 const mesh::LinkGrid         &link)
{
  const double density = scene.material.density;
  scene.parts[scene::Kind::roller] =
      std::make_shared<const mesh::Part>(mesh::make_roller(chain, density, roller));
  scene.parts[scene::Kind::inner_link] =
      std::make_shared<const mesh::Part>(mesh::make_inner_link(chain, density, link));
}

/// From the middle of an inner link to the second of its bushes, m.
inline Vector3 to_second_bush(const drive::ChainDimensions &chain)
{
  return vector(0.5 * chain.inner_hole_pitch, 0.);
}

/// Between the bore of a roller and a bush, radial, m.
inline double bush_clearance(const drive::ChainDimensions &chain)
{
  return 0.5 * (chain.roller_bore - chain.bush_diameter);
}

/// An inner link whose first bush touches the bore of a roller at @p roller [m] from above.
inline scene::Body link_on_roller(const drive::ChainDimensions &chain,
                                  const scene::Motion           motion,
                                  const double                  mass,
                                  const double                  inertia,
                                  const scene::Body            &roller)
{
  scene::Body link =
      body(motion,
           scene::Mount::free(),
           mass,
           vector(inertia, inertia, inertia),
           roller.initial.position + to_second_bush(chain) - vector(0., bush_clearance(chain)),
           roller.initial.velocity);
  link.kind = scene::Kind::inner_link;
  return link;
}

/// Body @p roller on the first or the @p second bush of body @p link.
inline scene::BorePair roller_on_bush(const drive::ChainDimensions &chain,
                                      const unsigned int            roller,
                                      const unsigned int            link,
                                      const bool                    second = false)
{
  const Vector3 at = (second ? 1. : -1.) * to_second_bush(chain);
  return {roller,
          dealii::Point<3>(),
          0.5 * chain.roller_bore,
          {link, dealii::Point<3>(at), 0.5 * chain.bush_diameter, second ? 1u : 0u},
          mesh::roller_bore,
          second ? mesh::bush_outside_second : mesh::bush_outside_first};
}

/// Where a roller of this @p radius is @p gap [m] before the flank, 3 mm above the bottom of the
/// seat for 525 and in proportion for others, and the normal there, in the sprocket's frame.
inline std::pair<Vector3, Vector3>
before_flank(const drive::ToothForm &form, const double radius, const double gap)
{
  const double r   = 0.5 * form.root_diameter + radius + 3e-3 * form.pitch / 15.875e-3;
  double       low = 0., high = dealii::numbers::PI / form.teeth;
  const auto   at = [&](const double angle) {
    return dealii::Point<2>(r * std::cos(angle), r * std::sin(angle));
  };
  for (unsigned int i = 0; i < 60; ++i)
    {
      const double middle                                                   = 0.5 * (low + high);
      (form.closest_point(at(middle)).distance > radius + gap ? low : high) = middle;
    }
  const auto x = at(low);
  const auto n = form.closest_point(x).normal;
  return {vector(x[0], x[1]), vector(n[0], n[1])};
}
} // namespace test
