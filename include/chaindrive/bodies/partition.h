// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/scene/scene.h>

#include <map>
#include <utility>
#include <vector>

namespace chaindrive
{
/// Which rank owns which elastic bodies.
struct Partition
{
  /// Of the bodies of one part and motion, in batches: the first batch of each rank, and the number
  /// of batches.
  std::map<std::pair<scene::Motion, scene::PartOf>, std::vector<unsigned int>> first_batch;
};

/// How many batches of a part's reduced bodies have neighbours along the chain in turn: two of
/// rollers belong to one of links, with the first and with the second bush.
unsigned int batches_in_turn(const scene::PartOf &of);

/// The bodies of each part that move by @p motion, ascending.
std::map<scene::PartOf, std::vector<unsigned int>> bodies_that_move(const scene::Scene &scene,
                                                                    scene::Motion       motion);

/// Distributes them over @p n_ranks ranks, in equal shares of elements, modes and joints.
Partition partition(const scene::Scene &scene, unsigned int n_ranks);
} // namespace chaindrive
