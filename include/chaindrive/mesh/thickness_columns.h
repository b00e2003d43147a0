// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/nodes.h>

#include <vector>

namespace chaindrive::mesh
{
/// The nodes of @p part that lie behind each node of the side @p surface, from there along edges of
/// cells to the opposite side of the wall; ascending in the number of their first node. @p nodes
/// are those of @p part.
std::vector<std::vector<unsigned int>>
thickness_columns(const Part &part, const Nodes &nodes, Surface surface);
} // namespace chaindrive::mesh
