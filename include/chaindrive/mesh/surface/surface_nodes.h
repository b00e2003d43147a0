// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/nodes.h>

#include <vector>

namespace chaindrive::mesh
{
/// The nodes of one named side of a part, in ascending order.
struct SurfaceNodes
{
  /// @p nodes are those of @p part.
  SurfaceNodes(const Part &part, const Nodes &nodes, Surface surface);

  /// Keeps of them those that are among @p nodes of the part; all if there are none.
  void keep(const std::vector<unsigned int> &nodes);

  unsigned int size() const { return static_cast<unsigned int>(node.size()); }

  std::vector<unsigned int> node;
  std::vector<double>       area; ///< a quarter of each adjoining face, m2

  /// Mean thickness [m] of the cells below the side: their volume over the area of their face.
  double thickness;
};
} // namespace chaindrive::mesh
