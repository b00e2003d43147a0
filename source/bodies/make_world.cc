// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/elastic_rim.h>
#include <chaindrive/bodies/hubs.h>
#include <chaindrive/bodies/make_world.h>
#include <chaindrive/bodies/partition.h>
#include <chaindrive/bodies/reduced_bodies.h>
#include <chaindrive/bodies/rigid_bodies.h>
#include <chaindrive/bodies/rigid_surface_nodes.h>
#include <chaindrive/bodies/tied_spins.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/ranks.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

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

/// @p bodies of a part, rank by rank: those in joints with bores of another rank's bodies, by
/// @p is_shared, come last of each, since a batch with one of them is shared.
std::vector<unsigned int> by_rank(const std::vector<unsigned int> &bodies,
                                  const std::vector<unsigned int> &rank_of,
                                  const std::vector<char>         &is_shared,
                                  const unsigned int               n_ranks)
{
  std::vector<unsigned int> order;
  for (unsigned int rank = 0; rank < n_ranks; ++rank)
    for (const bool shared : {false, true})
      for (const unsigned int body : bodies)
        if (rank_of[body] == rank && (is_shared[body] != 0) == shared)
          order.push_back(body);
  return order;
}

/// Makes the copies of elastic @p bodies of a part, and returns their number in World::copies.
unsigned int add_copies(const scene::Scene              &scene,
                        const scene::PartOf             &of,
                        const std::vector<unsigned int> &bodies,
                        const std::vector<unsigned int> &first_batch,
                        World                           &world)
{
  const unsigned int group = static_cast<unsigned int>(world.copies.size());
  world.copies.emplace_back(
      scene.parts.at(of), bodies, scene.bodies, first_batch, world.communicator());
  for (unsigned int k = 0; k < bodies.size(); ++k)
    world.elastic_address[bodies[k]] = {group, k};
  return group;
}

/// Makes the elastic rim of the sprocket @p body and leaves its hub the inertia of the rest.
void add_rim(const scene::Scene              &scene,
             const unsigned int               body,
             const std::vector<unsigned int> &first_batch,
             World                           &world)
{
  const scene::Body &sprocket = scene.bodies[body];
  const auto        &sector   = scene.sectors.at(sprocket.part());
  std::vector<Frame> start;
  for (unsigned int s = 0; s < sector->n_sectors; ++s)
    start.push_back(sector->frame(sprocket.initial, s));
  world.copies.emplace_back(sector->part,
                            std::vector<unsigned int>(start.size(), body),
                            start,
                            first_batch,
                            world.communicator());
  world.rims.emplace_back(
      body, static_cast<unsigned int>(world.copies.size()) - 1, sector, world.copies.back());
  for (World::Hub &hub : world.hubs)
    if (hub.body == body)
      hub.inertia -= world.symmetry.whole(world.rims.back().inertia);
  world.groups.add(
      std::make_unique<ElasticRim>(scene, world, static_cast<unsigned int>(world.rims.size()) - 1));
}

void add_elastic_bodies(const scene::Scene &scene, const Partition &partitioned, World &world)
{
  constexpr scene::Motion elastic = scene::Motion::elastic;
  for (const auto &[of, bodies] : bodies_that_move(scene, elastic))
    {
      const std::vector<unsigned int> &first_batch = partitioned.first_batch.at({elastic, of});
      if (scene.sectors.count(of) != 0)
        {
          add_rim(scene, bodies.front(), first_batch, world);
          continue;
        }
      const unsigned int group = add_copies(scene, of, bodies, first_batch, world);
      if (!scene.plates_bend)
        world.copies.back().stop_plate_bending();
      if (!scene.drive.bushes.empty() && of.kind == scene::Kind::inner_link)
        world.turning.insert(world.turning.end(), bodies.begin(), bodies.end());
      world.groups.add(std::make_unique<ElasticBodies>(scene, world, group));
    }
}

void add_reduced_bodies(const scene::Scene &scene, const Partition &partitioned, World &world)
{
  constexpr scene::Motion reduced  = scene::Motion::reduced;
  const unsigned int      n_ranks  = n_ranks_in(world.communicator());
  const auto              of_parts = bodies_that_move(scene, reduced);

  std::vector<unsigned int> rank_of(scene.bodies.size(), n_ranks); // none
  std::vector<char>         is_shared(scene.bodies.size(), 0);
  if (!partitioned.rank_of_piece.empty())
    {
      for (const auto &[of, bodies] : of_parts)
        for (unsigned int i = 0; i < bodies.size(); ++i)
          rank_of[bodies[i]] = partitioned.rank_of_piece[i / (batches_in_turn(of) * n_lanes / 2)];
      for (const scene::BoreFamily &bores : scene.bores)
        for (const scene::BorePair &pair : bores.pairs)
          if (rank_of[pair.master] < n_ranks && rank_of[pair.slave.body] != rank_of[pair.master])
            is_shared[pair.slave.body] = 1;
    }
  for (const auto &[of, bodies] : of_parts)
    {
      const unsigned int in_turn  = batches_in_turn(of);
      const auto         in_order = partitioned.rank_of_piece.empty() ?
                                        in_pieces(bodies, in_turn * n_lanes, n_ranks) :
                                        by_rank(bodies, rank_of, is_shared, n_ranks);
      const unsigned int group    = add_copies(scene,
                                            of,
                                            neighbours_in_batches(in_order, in_turn),
                                            partitioned.first_batch.at({reduced, of}),
                                            world);
      world.copies.back().count_readers();
      world.groups.add(std::make_unique<ReducedBodies>(scene, world, group));
    }
}

/// The sides of bodies whose nodes touch though they do not deform, by part and body.
std::map<scene::PartOf, std::map<unsigned int, std::set<unsigned int>>>
rigid_sides(const scene::Scene &scene)
{
  std::map<scene::PartOf, std::map<unsigned int, std::set<unsigned int>>> sides;
  for (const scene::BoreFamily &bores : scene.bores)
    if (bores.elastic)
      for (const scene::BorePair &pair : bores.pairs)
        for (const auto &[body, side] : {std::make_pair(pair.master, pair.master_surface),
                                         std::make_pair(pair.slave.body, pair.slave_surface)})
          if (!deforms(scene.bodies[body].motion))
            sides[scene.bodies[body].part()][body].insert(side);
  return sides;
}

/// Makes copies of the meshes of rigid bodies whose nodes touch. The first rank owns them.
void add_rigid_surface_nodes(const scene::Scene &scene, World &world)
{
  for (const auto &[of, of_bodies] : rigid_sides(scene))
    {
      const unsigned int        group = static_cast<unsigned int>(world.copies.size());
      std::vector<unsigned int> bodies;
      for (const auto &entry : of_bodies)
        {
          world.node_address[entry.first] = {group, static_cast<unsigned int>(bodies.size())};
          bodies.push_back(entry.first);
        }
      std::vector<unsigned int> first_batch(n_ranks_in(world.communicator()) + 1,
                                            BodyBatches::n_batches_of(bodies.size()));
      first_batch.front() = 0;
      world.copies.emplace_back(
          scene.parts.at(of), bodies, scene.bodies, first_batch, world.communicator());

      const BodyBatches                   &copies = world.copies.back();
      std::vector<RigidSurfaceNodes::Side> rigid_surface_nodes;
      for (const auto &[body, surfaces] : of_bodies)
        for (const unsigned int surface : surfaces)
          rigid_surface_nodes.push_back(
              {body,
               world.node_address[body].copy,
               mesh::SurfaceNodes(*copies.part, copies.nodes, static_cast<mesh::Surface>(surface))
                   .node});
      world.groups.add(std::make_unique<RigidSurfaceNodes>(group, std::move(rigid_surface_nodes)));
    }
}
} // namespace

World make_world(const scene::Scene &scene, const MPI_Comm comm)
{
  World world(scene, comm);
  if (scene.planar)
    world.planar = &world.groups.add(std::make_unique<PlanarBodies>(scene, world));
  else
    world.groups.add(std::make_unique<RigidBodies>());
  if (!world.tied.empty())
    world.groups.add(std::make_unique<TiedSpins>());
  world.groups.add(std::make_unique<Hubs>());
  const Partition partitioned = partition(scene, n_ranks_in(comm));
  add_elastic_bodies(scene, partitioned, world);
  add_reduced_bodies(scene, partitioned, world);
  world.node_address = world.elastic_address;
  add_rigid_surface_nodes(scene, world);
  return world;
}
} // namespace chaindrive
