// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Rows of elastic links, inner and outer ones by turns, joined by pins in bushes.

#include "reduced.h"

#include <chaindrive/drive/stiffness.h>
#include <chaindrive/mesh/surface/surface_nodes.h>

#include <algorithm>

namespace test
{
/// Stiffness of the penalty between pins and bushes of the link parts in @p scene, per area, with
/// the factor 0.5 [N/m3].
inline double penalty_of_pins(const scene::Scene &scene, const Material &material)
{
  const auto thickness = [&](const scene::Kind kind, const mesh::Surface side) {
    const mesh::Part &part = *scene.parts.at(kind);
    return mesh::SurfaceNodes(part, mesh::Nodes(part), side).thickness;
  };
  return 0.5 * material.bulk_modulus() /
         std::max(thickness(scene::Kind::inner_link, mesh::bush_bore_first),
                  thickness(scene::Kind::outer_link, mesh::pin_outside_first));
}

/// The pins of @p n_links links, the first of which is an inner one, in a @p scene that has their
/// parts. Windows are as wide as the working pressure under the tension @p load [N] asks.
inline scene::BoreFamily pins_of_links(const scene::Scene           &scene,
                                       const drive::ChainDimensions &chain,
                                       const Material               &material,
                                       const double                  load,
                                       const unsigned int            n_links)
{
  scene::BoreFamily pins;
  pins.name          = "bush-pin";
  pins.elastic       = true;
  pins.law.stiffness = penalty_of_pins(scene, material);
  pins.half_angle    = drive::largest_half_angle(0.5 * chain.pin_diameter,
                                              chain.pin_clearance(),
                                              drive::working_pressure(chain, load),
                                              material);
  for (unsigned int joint = 0; joint + 1 < n_links; ++joint)
    {
      const bool         inner_first = joint % 2 == 0;
      const unsigned int inner       = joint + (inner_first ? 0 : 1),
                         outer       = joint + (inner_first ? 1 : 0);
      pins.pairs.push_back(
          {inner,
           dealii::Point<3>((inner_first ? 0.5 : -0.5) * chain.inner_hole_pitch, 0., 0.),
           0.5 * chain.bush_bore,
           {outer, dealii::Point<3>(), 0.5 * chain.pin_diameter, joint},
           inner_first ? mesh::bush_bore_second : mesh::bush_bore_first,
           inner_first ? mesh::pin_outside_first : mesh::pin_outside_second});
    }
  return pins;
}
} // namespace test
