// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>

namespace chaindrive::mesh
{
/// Numbers of cells of a roller, from a refinement level 0 ... 4 or one by one.
struct RollerGrid
{
  RollerGrid(unsigned int refinement);
  RollerGrid(unsigned int wall, unsigned int around, unsigned int along, bool half = false)
      : wall(wall), around(around), along(along), half(half)
  {
  }

  unsigned int wall, around;
  unsigned int along;        ///< of the whole roller; even: vertices lie in the middle plane
  bool         half = false; ///< see Part::half
};

/// Numbers of cells of a link, from a refinement level 0 ... 4 or one by one.
struct LinkGrid
{
  unsigned int around;       ///< a hole; a multiple of four
  unsigned int wall;         ///< of a bush or pin
  unsigned int rings;        ///< of a plate about each hole
  unsigned int plate_layers; ///< through the thickness of a plate
  unsigned int along;        ///< a bush or pin between the plates; even
  bool         half = false; ///< see Part::half
  /// Where the roller or bush ends that bears on this bush or pin, z [m]: nodes lie there, and one
  /// cell reaches from there to the plate. 0: cells are equally long.
  double bearing_end = 0.;
};
LinkGrid inner_link_grid(unsigned int refinement);
LinkGrid outer_link_grid(unsigned int refinement);

/// A roller: origin at its centre, axis z.
Part make_roller(const drive::ChainDimensions &chain, double density, const RollerGrid &grid);

/// Two inner plates and two bushes in one mesh: origin midway between the axes, x from the first
/// joint to the second, z across the chain.
///
/// A bush or pin has the length from one plate's middle surface to the other's, as chains of plates
/// without thickness are described. Its mesh goes on to the outer face of the plates, so that the
/// joint of hole and bush is as thick as the plate and bends nothing; the bush's density factor
/// gives it the mass of its nominal length.
Part make_inner_link(const drive::ChainDimensions &chain, double density, const LinkGrid &grid);

/// Two outer plates and two pins in one mesh; see make_inner_link().
Part make_outer_link(const drive::ChainDimensions &chain, double density, const LinkGrid &grid);
} // namespace chaindrive::mesh
