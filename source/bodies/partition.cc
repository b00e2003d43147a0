// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/bodies/partition.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/reduction/basis.h>

#include <algorithm>

namespace chaindrive
{
namespace
{
/// Batches of one group of copies, to be distributed over the ranks.
struct PartitionGroup
{
  unsigned int n_batches;
  double       cost;  ///< of each
  bool         apart; ///< they touch few batches of other groups: any rank may have any of them
};

/// What a joint costs the owner of its bore, in elements: some 75 visits of a node, 37 ns each,
/// beside 16 ns (doc/performance.md).
constexpr double elements_per_joint = 170.;

/// What the nodes of sides that touch cost a reduced body per mode, in elements.
constexpr double elements_per_mode = 2.;

/// Distributes the batches of each group over @p n_ranks ranks in turn: equal shares, and what does
/// not go up to those that have least so far, the last of them, since the first rank has results to
/// take care of. Batches that may be apart even out the load. Returns per group the first batch of
/// each rank, and the number of batches.
std::vector<std::vector<unsigned int>> distribute(const std::vector<PartitionGroup> &groups,
                                                  const unsigned int                 n_ranks)
{
  std::vector<double>                    load(n_ranks, 0.);
  std::vector<std::vector<unsigned int>> result;
  for (const PartitionGroup &group : groups)
    {
      const unsigned int        share = group.apart ? 0 : group.n_batches / n_ranks;
      std::vector<unsigned int> count(n_ranks, share);
      for (double &l : load)
        l += share * group.cost;
      for (unsigned int i = n_ranks * share; i < group.n_batches; ++i)
        {
          const auto least = std::min_element(load.rbegin(), load.rend());
          *least += group.cost;
          ++count[load.rend() - least - 1];
        }
      std::vector<unsigned int> first = {0};
      for (const unsigned int n : count)
        first.push_back(first.back() + n);
      result.push_back(first);
    }
  return result;
}
} // namespace

unsigned int batches_in_turn(const scene::PartOf &of)
{
  return of.kind == scene::Kind::roller ? 2 : 1;
}

std::map<scene::PartOf, std::vector<unsigned int>> bodies_that_move(const scene::Scene &scene,
                                                                    const scene::Motion motion)
{
  std::map<scene::PartOf, std::vector<unsigned int>> found;
  for (unsigned int b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].motion == motion)
      found[scene.bodies[b].part()].push_back(b);
  return found;
}

Partition partition(const scene::Scene &scene, const unsigned int n_ranks)
{
  using Kind = std::pair<scene::Motion, scene::PartOf>;
  std::map<Kind, unsigned int> n_bodies;
  for (const scene::Body &body : scene.bodies)
    if (deforms(body.motion))
      ++n_bodies[{body.motion, body.part()}];
  std::map<Kind, unsigned int> n_joints; // at bores of elastic bodies
  for (const scene::BoreFamily &bores : scene.bores)
    for (const scene::BorePair &pair : bores.pairs)
      if (const scene::Body &master = scene.bodies[pair.master];
          bores.elastic && deforms(master.motion))
        ++n_joints[{master.motion, master.part()}];

  std::vector<PartitionGroup> groups_of_batches;
  for (const auto &[kind, n] : n_bodies)
    {
      const auto &[motion, of] = kind;
      const auto   sector      = scene.sectors.find(of);
      const bool   is_rim      = motion == scene::Motion::elastic && sector != scene.sectors.end();
      const auto  &part        = is_rim ? *sector->second->part : *scene.parts.at(of);
      const double alone       = motion == scene::Motion::reduced ?
                                     elements_per_mode * scene.bases.at(of)->size() :
                                     part.mesh->n_active_cells();
      groups_of_batches.push_back(
          {BodyBatches::n_batches_of(is_rim ? sector->second->n_sectors : n),
           alone + elements_per_joint * n_joints[kind] / double(n),
           is_rim});
    }
  const auto first_batches = distribute(groups_of_batches, n_ranks);

  Partition result;
  auto      first_batch = first_batches.begin();
  for (const auto &entry : n_bodies)
    result.first_batch[entry.first] = *first_batch++;
  return result;
}
} // namespace chaindrive
