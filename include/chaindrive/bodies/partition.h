// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/scene/scene.h>

#include <map>
#include <utility>
#include <vector>

namespace chaindrive
{
/// Which rank owns which batches of the elastic bodies of one part and motion: the first batch of
/// each rank, and the number of batches.
using Partition = std::map<std::pair<scene::Motion, scene::PartOf>, std::vector<unsigned int>>;

/// Distributes them over @p n_ranks ranks. Loads are equal shares of elements, modes and joints.
Partition partition(const scene::Scene &scene, unsigned int n_ranks);
} // namespace chaindrive
