// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/chain_shares.h>
#include <chaindrive/mesh/part.h>

#include <algorithm>
#include <array>

namespace chaindrive
{
namespace
{
/// The @p bodies in such an order that the copies of a batch are neighbours along the chain: they
/// touch others at about the same nodes. Neighbours are distributed over @p n_in_turn batches in
/// turn: two of rollers then belong to one of links, with the first and with the second bush.
std::vector<unsigned int> neighbours_in_batches(const std::vector<unsigned int> &bodies,
                                                const unsigned int               n_in_turn)
{
  const unsigned int        n_batches = BodyBatches::n_batches_of(bodies.size());
  std::vector<unsigned int> copies(bodies.size());
  auto                      next = bodies.begin();
  for (unsigned int first = 0; first < n_batches; first += n_in_turn)
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      for (unsigned int batch = first; batch < std::min(first + n_in_turn, n_batches); ++batch)
        if (const unsigned int copy = lane * n_batches + batch; copy < copies.size())
          copies[copy] = *next++;
  return copies;
}

/// @p bodies in pieces of the chain of @p length bodies, distributed over the ranks in turn: what
/// touches teeth, which costs more, is then spread over them. The last piece may be shorter, and
/// stays last.
std::vector<unsigned int> in_pieces(const std::vector<unsigned int> &bodies,
                                    const std::size_t                length,
                                    const unsigned int               n_ranks)
{
  const std::size_t         n_pieces = (bodies.size() + length - 1) / length;
  std::vector<unsigned int> order;
  const auto                take_piece = [&](const std::size_t piece) {
    for (std::size_t i = piece * length; i < std::min((piece + 1) * length, bodies.size()); ++i)
      order.push_back(bodies[i]);
  };
  for (unsigned int rank = 0; rank < n_ranks; ++rank)
    for (std::size_t piece = rank; piece + 1 < n_pieces; piece += n_ranks)
      take_piece(piece);
  if (n_pieces > 0)
    take_piece(n_pieces - 1);
  return order;
}

/// Inner links whose joints have the same ranks.
struct Share
{
  JointRanks   ranks;
  unsigned int n_links;
};

/// How many batches of joints each rank is to have, of @p n in all.
std::vector<unsigned int>
batches_of_joints(const unsigned int n, const unsigned int n_ranks, const double observing)
{
  std::vector<double> load(n_ranks, 0.);
  load.front() = observing;
  std::vector<unsigned int> count(n_ranks, 0);
  for (unsigned int batch = 0; batch < n; ++batch)
    {
      const auto least = std::min_element(load.rbegin(), load.rend());
      *least += 1.;
      ++count[load.rend() - least - 1];
    }
  return count;
}

/// Links in the order of their batches: of each rank, and of it with the next one. Where that one
/// has an even number of batches, it has one more in place of the next that has an odd number.
std::vector<Share>
shares_of(const unsigned int n_links, const unsigned int n_ranks, const double observing)
{
  const unsigned int n_batches = BodyBatches::n_batches_of(n_links);
  const auto         count     = batches_of_joints(2 * n_batches, n_ranks, observing);
  std::vector<Share> shares;
  unsigned int       batch = 0;
  const auto         add   = [&](const JointRanks &ranks, const unsigned int n) {
    unsigned int links = 0;
    for (const unsigned int end = batch + n; batch < end; ++batch)
      links += (n_links - batch + n_batches - 1) / n_batches;
    if (links > 0)
      shares.push_back({ranks, links});
  };
  bool shares_with_next = false;
  for (unsigned int rank = 0; rank < n_ranks; ++rank)
    {
      add({{rank, rank}}, count[rank] / 2);
      if (count[rank] % 2 == 0)
        continue;
      shares_with_next = !shares_with_next;
      if (shares_with_next)
        add({{rank, rank + 1}}, 1);
    }
  return shares;
}

/// Whether a side of a link is that at its second joint.
bool is_second(const unsigned int surface)
{
  return surface == mesh::bush_outside_second || surface == mesh::bush_bore_second ||
         surface == mesh::pin_outside_second;
}

/// Which ranks have to do with each reduced body of a scene.
class RanksOfBodies
{
public:
  /// @p of_parts are the bodies; @p joints are those of inner links.
  RanksOfBodies(const scene::Scene                                       &scene,
                const std::map<scene::PartOf, std::vector<unsigned int>> &of_parts,
                const std::vector<JointRanks>                            &joints)
      : place_(scene.bodies.size(), 0)
      , home_(scene.bodies.size(), nobody)
      , joints_(scene.bodies.size())
      , touched_by_(scene.bodies.size())
  {
    for (const auto &[of, bodies] : of_parts)
      for (unsigned int i = 0; i < bodies.size(); ++i)
        {
          const unsigned int n_in_turn = batches_in_turn(of), body = bodies[i];
          const JointRanks  &of_link = joints[i / n_in_turn];
          place_[body]  = 2 * std::min(of_link[0], of_link[1]) + (of_link[0] != of_link[1] ? 1 : 0);
          joints_[body] = of_link;
          if (of.kind == scene::Kind::roller)
            joints_[body].fill(of_link[i % n_in_turn]);
          // of links that two ranks share, one has the inner ones and the other the outer ones
          home_[body] = joints_[body][of.kind == scene::Kind::outer_link ? 1 : 0];
          touched_by_[body].fill(home_[body]);
        }
    for (const scene::BoreFamily &bores : scene.bores)
      for (const scene::BorePair &pair : bores.pairs)
        if (home_[pair.master] != nobody)
          {
            const unsigned int rank = joints_[pair.master][is_second(pair.master_surface) ? 1 : 0];
            touched_by_[pair.master][is_second(pair.master_surface) ? 1 : 0]    = rank;
            touched_by_[pair.slave.body][is_second(pair.slave_surface) ? 1 : 0] = rank;
          }
  }

  unsigned int      home(const unsigned int body) const { return home_[body]; }
  const JointRanks &joints(const unsigned int body) const { return joints_[body]; }

  /// Smaller for those that come first: by rank, and those that it shares with the next one. Those
  /// that others touch as well come last, of every second rank first, so that they are beside those
  /// of the next rank; by who touches which end, since a rank then reads one end of a batch.
  std::array<unsigned int, 4> key(const unsigned int body) const
  {
    const bool shared = touched_by_[body] != JointRanks{{home_[body], home_[body]}};
    const bool last   = place_[body] / 2 % 2 == 0;
    return {{place_[body],
             shared == last ? 1u : 0u,
             shared ? touched_by_[body][0] : 0u,
             shared ? touched_by_[body][1] : 0u}};
  }

private:
  static constexpr unsigned int nobody = static_cast<unsigned int>(-1);

  std::vector<unsigned int> place_; ///< of the ranks of its link in the order of batches
  std::vector<unsigned int> home_;  ///< rank
  std::vector<JointRanks>   joints_, touched_by_;
};

/// How many inner links there are in whole batches, the same number of @p of_parts all; 0: not.
unsigned int n_links_of(const std::map<scene::PartOf, std::vector<unsigned int>> &of_parts)
{
  unsigned int most = 0, least = static_cast<unsigned int>(-1);
  for (const auto &[of, bodies] : of_parts)
    {
      const unsigned int n_in_turn = batches_in_turn(of);
      const auto         n = static_cast<unsigned int>((bodies.size() + n_in_turn - 1) / n_in_turn);
      most                 = std::max(most, n);
      least                = std::min(least, n);
    }
  return BodyBatches::n_batches_of(most) == BodyBatches::n_batches_of(least) ? most : 0;
}

/// The first batch of each rank: of batches with bodies of several ranks, that of most.
std::vector<unsigned int> first_batches(const std::vector<unsigned int> &bodies,
                                        const RanksOfBodies             &ranks,
                                        const unsigned int               n_ranks)
{
  const unsigned int        n_batches = BodyBatches::n_batches_of(bodies.size());
  std::vector<unsigned int> first(n_ranks + 1, n_batches);
  first.front()    = 0;
  unsigned int now = 0;
  for (unsigned int batch = 0; batch < n_batches; ++batch)
    {
      std::vector<unsigned int> count(n_ranks, 0);
      for (unsigned int copy = batch; copy < bodies.size(); copy += n_batches)
        ++count[ranks.home(bodies[copy])];
      const auto most =
          static_cast<unsigned int>(std::max_element(count.begin(), count.end()) - count.begin());
      while (now < most)
        first[++now] = batch;
    }
  return first;
}

/// What the first rank spends on observing the run and writing results, over what reduced bodies
/// and their joints cost all ranks: 0.04 in reduced-half and 0.02 in reduced without penalty, with
/// a sample every 5 us and fields every millisecond (doc/performance.md).
constexpr double observing_share = 0.03;
} // namespace

std::vector<JointRanks>
share_joints(const unsigned int n_links, const unsigned int n_ranks, const double observing)
{
  constexpr unsigned int    together = 2; // links
  const auto                shares   = shares_of(n_links, n_ranks, observing);
  std::vector<unsigned int> given(shares.size(), 0);
  std::vector<JointRanks>   ranks;
  while (ranks.size() < n_links)
    {
      const double done = double(ranks.size() + together) / n_links;
      unsigned int next = 0;
      double       most = -double(n_links); // behind its share so far
      for (unsigned int s = 0; s < shares.size(); ++s)
        if (const double behind = shares[s].n_links * done - given[s];
            given[s] < shares[s].n_links && behind > most)
          {
            most = behind;
            next = s;
          }
      const unsigned int n = std::min(together, shares[next].n_links - given[next]);
      ranks.insert(ranks.end(), n, shares[next].ranks);
      given[next] += n;
    }
  return ranks;
}

std::map<scene::PartOf, ChainShare>
share_chain(const scene::Scene &scene, const Partition &partition, const unsigned int n_ranks)
{
  constexpr scene::Motion             reduced   = scene::Motion::reduced;
  const auto                          of_parts  = bodies_that_move(scene, reduced);
  const unsigned int                  n_links   = of_parts.empty() ? 0 : n_links_of(of_parts);
  const unsigned int                  n_batches = BodyBatches::n_batches_of(n_links);
  std::map<scene::PartOf, ChainShare> shares;
  if (n_ranks == 1 || n_batches < n_ranks)
    {
      for (const auto &[of, bodies] : of_parts)
        {
          const unsigned int n_in_turn = batches_in_turn(of);
          ChainShare        &share     = shares[of];
          share.bodies =
              neighbours_in_batches(in_pieces(bodies, n_in_turn * n_lanes, n_ranks), n_in_turn);
          share.first_batch = partition.first_batch.at({reduced, of});
        }
      return shares;
    }

  const RanksOfBodies ranks(
      scene, of_parts, share_joints(n_links, n_ranks, 2. * observing_share * n_batches));
  for (const auto &[of, bodies] : of_parts)
    {
      std::vector<unsigned int> order = bodies;
      std::stable_sort(
          order.begin(), order.end(), [&ranks](const unsigned int a, const unsigned int b) {
            return ranks.key(a) < ranks.key(b);
          });
      ChainShare &share = shares[of];
      share.bodies      = neighbours_in_batches(order, batches_in_turn(of));
      share.first_batch = first_batches(share.bodies, ranks, n_ranks);
      for (const unsigned int body : share.bodies)
        share.joint_ranks.push_back(ranks.joints(body));
    }
  return shares;
}
} // namespace chaindrive
