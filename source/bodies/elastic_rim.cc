// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/elastic_rim.h>
#include <chaindrive/bodies/node_view.h>
#include <chaindrive/bodies/world.h>

namespace chaindrive
{
namespace
{
/// Adds @p sums over the nodes of each sector of @p batch to @p to.
void add_sectors(const BodyBatches &copies,
                 const unsigned int batch,
                 const double      *sums,
                 double            &to)
{
  copies.for_each_copy_of(batch, [&](unsigned int, const unsigned int lane) { to += sums[lane]; });
}

/// Gravity and drag act on no sprocket.
Step without_load(const Step &step)
{
  Step no_load    = step;
  no_load.gravity = no_load.drag = 0.;
  return no_load;
}
} // namespace

ElasticRim::ElasticRim(const scene::Scene &scene, const World &world, const unsigned int rim)
    : ElasticBodies(scene, world, world.rims[rim].group), rim_(rim)
{
}

void ElasticRim::drift(World &world, const Step & /*step*/)
{
  const Rim &rim = world.rims[rim_];
  rim.fix_to_hub(world.copies[group_], world.frames[rim.body]);
}

void ElasticRim::add_forces(World &world, const ForceTimer &timer)
{
  const Rim   &rim    = world.rims[rim_];
  BodyBatches &copies = world.copies[group_];
  for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
       ++batch)
    {
      alignas(64) Sums sums{};
      add_internal_forces(copies, batch, sums, timer);
      add_sectors(copies, batch, sums.strain, world.ledger.strain);
      add_sectors(copies, batch, sums.hourglass, world.ledger.hourglass);
    }

  // the hub takes the forces on the nodes that it holds
  const NodeView position(std::as_const(copies.position));
  const NodeView force(copies.force);
  for (unsigned int s = 0; s < copies.n_copies(); ++s)
    if (copies.owns(s))
      for (const unsigned int node : rim.border)
        {
          const std::size_t at = copies.index(s, node);
          world.add_force(rim.body, force.extract(at), position[at]);
        }
  rim.even_out_forces(copies);
}

void ElasticRim::start(World &world, const Step &step, const ForceTimer &timer)
{
  ElasticBodies::start(world, without_load(step), timer);
}

void ElasticRim::use_forces(World &world, const Step &step)
{
  ElasticBodies::use_forces(world, without_load(step));
}

void ElasticRim::advance(World &world, const Step &step, const ForceTimer & /*timer*/)
{
  Rim         &rim    = world.rims[rim_];
  BodyBatches &copies = world.copies[group_];
  if (step.moves)
    copies.ahead = step.dt;
  const Step no_load = without_load(step);
  for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
       ++batch)
    {
      alignas(64) Sums sums{};
      copies.hold_nodes(batch);
      update(copies, batch, sums, no_load, step.dt);
      add_sectors(copies, batch, sums.kinetic, world.ledger.kinetic);
      copies.for_each_copy_of(batch, [&](unsigned int, const unsigned int lane) {
        rim.momentum += Sums::of_lane(sums.momentum, lane);
      });
    }
}
} // namespace chaindrive
