// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/bodies/partition.h>
#include <chaindrive/scene/scene.h>

#include <map>
#include <vector>

namespace chaindrive
{
/// The reduced bodies of one part, as ranks share them.
struct ChainShare
{
  std::vector<unsigned int> bodies;      ///< of each copy, see BodyBatches
  std::vector<unsigned int> first_batch; ///< of each rank, and the number of batches
  std::vector<JointRanks>   joint_ranks; ///< as in BodyBatches
};

/// The reduced bodies of @p scene by part. Joints are distributed by share_joints(); links whose
/// joints are of two ranks are neighbours in batches, since a batch with one of them is shared.
/// Where there are fewer batches of links than ranks, or not as many of all parts, the batches of
/// each part go to the ranks that @p partition says.
std::map<scene::PartOf, ChainShare>
share_chain(const scene::Scene &scene, const Partition &partition, unsigned int n_ranks);

/// The ranks of the joints at both bushes of @p n_links inner links, along the chain. A rank has
/// whole batches of joints at first and of joints at second bushes. With an odd number of batches
/// it has the joints at one bush of some links, whose others are another rank's. Numbers of batches
/// make the largest load least, where the first rank has @p observing batches to begin with. Links
/// are distributed in turn, two at a time, so that each rank has its share of what touches teeth,
/// wherever the chain has gone.
std::vector<JointRanks> share_joints(unsigned int n_links, unsigned int n_ranks, double observing);
} // namespace chaindrive
