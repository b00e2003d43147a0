// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/scene/scene.h>

#include <map>
#include <vector>

namespace chaindrive
{
/// Which rank owns which batches of elastic bodies: per kind, the first batch of each of @p n_ranks
/// ranks, and the number of batches. Loads are equal shares of elements and joints.
std::map<scene::PartOf, std::vector<unsigned int>> partition(const scene::Scene &scene,
                                                             unsigned int        n_ranks);
} // namespace chaindrive
