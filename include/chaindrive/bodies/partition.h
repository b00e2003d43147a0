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

  /// Of reduced bodies the rank of each piece of the chain, half a batch of links with their
  /// rollers, so that each rank has its share of what touches teeth, wherever the chain has gone.
  /// Of a rank but the last, which has the last piece, they fill whole batches. Empty: there are
  /// not enough pieces, or not as many of all parts.
  std::vector<unsigned int> rank_of_piece;
};

/// How many batches of a part's reduced bodies have neighbours along the chain in turn: two of
/// rollers belong to one of links, with the first and with the second bush.
unsigned int batches_in_turn(const scene::PartOf &of);

/// The bodies of each part that move by @p motion, ascending.
std::map<scene::PartOf, std::vector<unsigned int>> bodies_that_move(const scene::Scene &scene,
                                                                    scene::Motion       motion);

/// Distributes them over @p n_ranks ranks. Loads are equal shares of elements, modes and joints;
/// the first rank has less of reduced bodies, since it observes the run as well.
Partition partition(const scene::Scene &scene, unsigned int n_ranks);

/// The ranks of @p n_pieces pieces that are as many as @p n_units pairs of them, the last of which
/// may be short or half. Units are shared out so that the largest load is least, where the first
/// rank has @p observing units to begin with; pieces of a rank are spread evenly over the chain.
/// There must be at least as many units as @p n_ranks.
std::vector<unsigned int>
spread_pieces(unsigned int n_pieces, unsigned int n_units, unsigned int n_ranks, double observing);
} // namespace chaindrive
