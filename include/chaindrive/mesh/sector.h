// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/nodes.h>
#include <chaindrive/mesh/part.h>
#include <chaindrive/utilities/rotation.h>

#include <memory>
#include <utility>
#include <vector>

namespace chaindrive::mesh
{
/// One of the equal sectors of a sprocket, its elastic zone only: the whole rim is n_sectors copies
/// of it, copy s turned by 2 pi s / n_sectors about z. Vertices between two sectors are there
/// twice, once in each. A mesh that is not made of sectors, such as an imported one, is a single
/// one.
struct Sector
{
  /// Of a sprocket @p whole. Throws InputError if it has no elastic zone, if nothing holds that, or
  /// if the rigid zone reaches the flanks.
  explicit Sector(const Part &whole);

  /// Frame of copy @p s of a sprocket that is placed as @p sprocket says.
  Frame frame(const Frame &sprocket, unsigned int s) const;

  /// Moments of inertia of all copies about the axis, kg m2.
  struct Inertia
  {
    double free; ///< of the nodes that the rigid zone does not hold
    double held; ///< of those that it holds
  };

  /// With the masses of @p nodes, which are those of part.
  Inertia inertia(const Nodes &nodes) const;

  unsigned int n_sectors;
  unsigned int n_cells; ///< of a sector of the whole, the rigid zone included

  /// The cells of sector 0 in the sprocket's frame. Sides keep their names; where the rigid zone
  /// holds the sector its side is `hub`, where the neighbours adjoin it has no name.
  std::shared_ptr<const Part> part;

  /// Per cell of part, its number in the whole: cell c of copy s is s * n_cells + whole_cell[c].
  std::vector<unsigned int> whole_cell;

  /// [sector][vertex of part]: the vertex of the whole mesh.
  std::vector<std::vector<unsigned int>> whole_vertex;

  /// Vertices of part: the first one of copy s is the same point as the second one of copy s + 1.
  /// None in a single sector.
  std::vector<std::pair<unsigned int, unsigned int>> seam;
};
} // namespace chaindrive::mesh
