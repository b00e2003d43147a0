// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>

#include <array>
#include <vector>

namespace chaindrive::mesh
{
/// The nodes of a part's elastic zone, all but a sprocket's hub zone, numbered in the order in
/// which its cells first use them: nodes of one cell are then near to each other in memory.
struct Nodes
{
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  explicit Nodes(const Part &part);

  unsigned int size() const { return static_cast<unsigned int>(vertex.size()); }

  std::vector<unsigned int>                vertex;    ///< of the mesh, per node
  std::vector<unsigned int>                of_vertex; ///< node per vertex of the mesh, or none
  std::vector<dealii::Point<3>>            position;  ///< in the part's frame, m
  std::vector<double>                      mass;      ///< lumped: row sums, kg
  std::vector<std::array<unsigned int, 8>> cells;     ///< nodes of each elastic cell
};
} // namespace chaindrive::mesh
