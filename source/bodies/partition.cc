// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/bodies/partition.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/reduction/basis.h>

#include <algorithm>
#include <limits>

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

/// What the first rank spends on observing the run and writing results, over what reduced bodies
/// and their joints cost all ranks: 0.04 in reduced-half and 0.02 in reduced without penalty, with
/// a sample every 5 us and fields every millisecond (doc/performance.md).
constexpr double observing_share = 0.03;

/// The number of units that @p bodies of reduced parts are, whole batches of all of them; 0: they
/// are not as many of all parts.
unsigned int units_of(const std::map<scene::PartOf, std::vector<unsigned int>> &bodies,
                      unsigned int                                              per_unit)
{
  unsigned int units = 0;
  for (const auto &[of, of_part] : bodies)
    {
      const std::size_t  length = std::size_t(batches_in_turn(of)) * per_unit;
      const unsigned int n      = static_cast<unsigned int>((of_part.size() + length - 1) / length);
      if (units != 0 && n != units)
        return 0;
      units = n;
    }
  return units;
}

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

std::vector<unsigned int> spread_pieces(const unsigned int n_pieces,
                                        const unsigned int n_units,
                                        const unsigned int n_ranks,
                                        const double       observing)
{
  std::vector<double> load(n_ranks, 0.);
  load.front() = observing;
  std::vector<unsigned int> wanted(n_ranks, 0); // pieces
  for (unsigned int unit = 0; unit < n_units; ++unit)
    {
      // the last rank, which has the last piece, comes first
      const auto least = std::min_element(load.rbegin(), load.rend());
      *least += 1.;
      wanted[load.rend() - least - 1] += 2;
    }
  wanted.back() -= 2 * n_units - n_pieces;

  // the first piece is the first rank's, since the last one, beside it, is another's
  std::vector<unsigned int> given(n_ranks, 0), ranks;
  for (unsigned int piece = 0; piece < n_pieces; ++piece)
    {
      unsigned int next = piece + 1 < n_pieces && wanted.front() > 0 ? 0 : n_ranks - 1;
      double       most = -std::numeric_limits<double>::max();
      for (unsigned int rank = n_ranks; 0 < piece && piece + 1 < n_pieces && rank-- > 0;)
        {
          // who is farthest behind its share so far
          const unsigned int kept   = rank + 1 == n_ranks ? 1 : 0; // the last piece
          const double       behind = wanted[rank] * (piece + 1.) / n_pieces - given[rank];
          if (given[rank] + kept < wanted[rank] && behind > most)
            {
              most = behind;
              next = rank;
            }
        }
      ++given[next];
      ranks.push_back(next);
    }
  return ranks;
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

  const auto         reduced  = bodies_that_move(scene, scene::Motion::reduced);
  const unsigned int n_units  = units_of(reduced, n_lanes),
                     n_pieces = units_of(reduced, n_lanes / 2);
  if (n_ranks == 1 || n_units < n_ranks || n_pieces == 0)
    return result;
  result.rank_of_piece = spread_pieces(n_pieces, n_units, n_ranks, observing_share * n_units);
  for (const auto &[of, bodies] : reduced)
    {
      const unsigned int        n_batches = BodyBatches::n_batches_of(bodies.size());
      std::vector<unsigned int> first     = {0};
      for (unsigned int rank = 0; rank + 1 < n_ranks; ++rank)
        first.push_back(
            first.back() +
            static_cast<unsigned int>(
                batches_in_turn(of) *
                std::count(result.rank_of_piece.begin(), result.rank_of_piece.end(), rank) / 2));
      first.push_back(n_batches);
      result.first_batch[{scene::Motion::reduced, of}] = first;
    }
  return result;
}
} // namespace chaindrive
