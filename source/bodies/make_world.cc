// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/chain_shares.h>
#include <chaindrive/bodies/elastic_rim.h>
#include <chaindrive/bodies/hubs.h>
#include <chaindrive/bodies/make_world.h>
#include <chaindrive/bodies/partition.h>
#include <chaindrive/bodies/reduced_bodies.h>
#include <chaindrive/bodies/rigid_bodies.h>
#include <chaindrive/bodies/rigid_surface_nodes.h>
#include <chaindrive/bodies/teeth_in_motion.h>
#include <chaindrive/bodies/tied_spins.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/ranks.h>

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace chaindrive
{
namespace
{
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
  const auto shares = share_chain(scene, partitioned, n_ranks_in(world.communicator()));
  for (const auto &[of, share] : shares)
    {
      const unsigned int group = add_copies(scene, of, share.bodies, share.first_batch, world);
      world.copies.back().joint_ranks = share.joint_ranks;
      world.copies.back().count_readers();
      world.groups.add(std::make_unique<ReducedBodies>(scene, world, group));
    }
}

/// Gives the teeth of sprockets whose rims have inertia their motion.
void add_teeth_in_motion(const scene::Scene &scene, World &world)
{
  for (const scene::ToothFamily &teeth : scene.teeth)
    if (teeth.rim_modes && world.teeth_of(teeth.sprocket) == nullptr)
      world.teeth.push_back(
          &world.groups.add(std::make_unique<TeethInMotion>(teeth.sprocket, teeth.rim_modes)));
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
  add_teeth_in_motion(scene, world);
  return world;
}
} // namespace chaindrive
