// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/elastic_bodies.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace chaindrive
{
ElasticBodies::ElasticBodies(const scene::Scene &scene,
                             const World        &world,
                             const unsigned int  group)
    : NodalGroup(group)
    , part_(*world.copies[group].part, world.copies[group].nodes, scene.material, scene.elements)
    , material_(scene.material)
    , critical_time_step_(2. / part_.largest_frequency())
    , kernels_(element::best_kernels())
{
  const BodyBatches &copies = world.copies[group];
  if (scene.drive.bushes.empty() ||
      scene.bodies[copies.bodies.front()].kind != scene::Kind::inner_link)
    return;
  for (unsigned int i = 0; i < 2; ++i)
    bushes_[i] = mesh::SurfaceNodes(*copies.part,
                                    copies.nodes,
                                    i == 0 ? mesh::bush_outside_first : mesh::bush_outside_second)
                     .node;
}

void ElasticBodies::start(World &world, const Step &step, const ForceTimer & /*timer*/)
{
  world.copies[group_].ahead = step.dt;
  move(world, step, 0.5 * step.dt);
}

void ElasticBodies::advance(World &world, const Step &step, const ForceTimer &timer)
{
  BodyBatches &copies = world.copies[group_];
  if (step.moves)
    copies.ahead = step.dt;
  for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
       ++batch)
    {
      alignas(64) Sums sums{};
      add_internal_forces(copies, batch, sums, timer);
      update(copies, batch, sums, step, step.dt);
      book(world, copies, batch, sums, step);
    }
}

void ElasticBodies::use_forces(World &world, const Step &step)
{
  Step kick = step;
  kick.dt   = 0.;
  move(world, kick, step.dt);
}

void ElasticBodies::move(World &world, const Step &step, const double kick) const
{
  BodyBatches &copies = world.copies[group_];
  for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
       ++batch)
    {
      alignas(64) Sums sums{};
      update(copies, batch, sums, step, kick);
    }
}

void ElasticBodies::add_internal_forces(BodyBatches       &copies,
                                        const unsigned int batch,
                                        Sums              &sums,
                                        const ForceTimer  &timer) const
{
  const std::size_t first = copies.start_of(batch);
  {
    const PhaseTimer::Scope scope(timer.timer, timer.phase);
    part_.add_forces({copies.position.begin() + first,
                      copies.force.begin() + first,
                      sums.strain,
                      sums.hourglass,
                      copies.velocity.begin() + first,
                      static_cast<unsigned int>(copies.stride())});
  }
  copies.hold_nodes(batch);
}

void ElasticBodies::update(BodyBatches       &copies,
                           const unsigned int batch,
                           Sums              &sums,
                           const Step        &step,
                           const double       kick) const
{
  const std::size_t first = copies.start_of(batch);
  if (!step.moves) // sums of a kick of no length, which uses up the forces
    {
      const std::vector<double> forces(copies.force.begin() + first,
                                       copies.force.begin() + first + copies.stride());
      Step                      still = step;
      still.dt                        = 0.;
      still.moves                     = true;
      update(copies, batch, sums, still, 0.);
      std::copy(forces.begin(), forces.end(), copies.force.begin() + first);
      return;
    }
  if (!part_.masses().empty())
    part_.masses().apply(kernels_,
                         kick,
                         step.drag,
                         copies.velocity.begin() + first,
                         copies.force.begin() + first,
                         sums.kinetic);
  kernels_.update({copies.n_nodes(),
                   kick,
                   step.dt,
                   {0., -step.gravity, 0.},
                   step.drag,
                   copies.nodes.mass.data(),
                   copies.position.begin() + first,
                   copies.velocity.begin() + first,
                   copies.force.begin() + first,
                   sums.kinetic,
                   sums.first_moment,
                   sums.momentum});
}

void ElasticBodies::book(World             &world,
                         const BodyBatches &copies,
                         const unsigned int batch,
                         const Sums        &sums,
                         const Step        &step) const
{
  copies.for_each_copy_of(batch, [&](const unsigned int copy, const unsigned int lane) {
    const unsigned int body  = copies.bodies[copy];
    Frame             &frame = world.frames[body];
    frame.position           = Sums::of_lane(sums.first_moment, lane);
    frame.velocity           = Sums::of_lane(sums.momentum, lane);
    for (unsigned int d = 0; d < 3; ++d)
      {
        frame.position[d] /= copies.mass;
        frame.velocity[d] /= copies.mass;
      }
    copies.part->symmetry().cancel_across(frame.position);
    copies.part->symmetry().cancel_across(frame.velocity);
    turn(world, copies, copy, frame);
    for (unsigned int d = 0; d < 3; ++d)
      {
        world.displacement.local_element(3 * body + d) = frame.position[d] - world.origin[body][d];
        world.velocity.local_element(3 * body + d)     = frame.velocity[d];
      }
    // contacts have added their resultants: these complete the force on the centre of mass
    world.force.local_element(3 * body + 1) -= copies.mass * step.gravity;
    for (unsigned int d = 0; d < 3; ++d)
      world.force.local_element(3 * body + d) -= copies.mass * step.drag * frame.velocity[d];
    Ledger &ledger = world.ledger;
    ledger.kinetic += sums.kinetic[lane];
    ledger.strain += sums.strain[lane];
    ledger.hourglass += sums.hourglass[lane];
    ledger.potential += copies.mass * step.gravity * world.displacement.local_element(3 * body + 1);
    ledger.drag += 2. * step.drag * sums.kinetic[lane] * step.dt;
  });
}

void ElasticBodies::turn(const World       &world,
                         const BodyBatches &copies,
                         const unsigned int copy,
                         Frame             &frame) const
{
  if (bushes_[0].empty())
    return;
  dealii::Tensor<1, 3> line, speed;
  for (unsigned int i = 0; i < 2; ++i)
    for (const unsigned int node : bushes_[i])
      {
        const double share = (i == 0 ? -1. : 1.) / static_cast<double>(bushes_[i].size());
        line += share * position_now(world, copy, node);
        speed += share * NodeView(copies.velocity)[copies.index(copy, node)];
      }
  const double square       = line[0] * line[0] + line[1] * line[1];
  frame.rotation            = to_matrix(rotation_about_z(std::atan2(line[1], line[0])));
  frame.angular_velocity[2] = (line[0] * speed[1] - line[1] * speed[0]) / square;
}

dealii::Tensor<1, 3> ElasticBodies::position_now(const World       &world,
                                                 const unsigned int copy,
                                                 const unsigned int node) const
{
  return world.copies[group_].position_now(copy, node);
}

dealii::Tensor<1, 3> ElasticBodies::velocity_now(const World       &world,
                                                 const unsigned int copy,
                                                 const unsigned int node) const
{
  const BodyBatches &copies = world.copies[group_];
  return NodeView(copies.velocity)[copies.index(copy, node)];
}

void ElasticBodies::nodes_now(const World                       &world,
                              const unsigned int                 copy,
                              std::vector<dealii::Tensor<1, 3>> &position,
                              std::vector<dealii::Tensor<1, 3>> &velocity) const
{
  const unsigned int n_nodes = world.copies[group_].n_nodes();
  position.resize(n_nodes);
  velocity.resize(n_nodes);
  for (unsigned int node = 0; node < n_nodes; ++node)
    {
      position[node] = ElasticBodies::position_now(world, copy, node);
      velocity[node] = ElasticBodies::velocity_now(world, copy, node);
    }
}

void ElasticBodies::serialize(const Archive &archive, World &world)
{
  world.copies[group_].serialize(archive);
}

std::vector<std::unique_ptr<const element::StressRecovery>>
ElasticBodies::stress_recoveries(const World &world) const
{
  const BodyBatches                                          &copies = world.copies[group_];
  std::vector<std::unique_ptr<const element::StressRecovery>> recoveries;
  for (const auto &block : part_.blocks())
    recoveries.push_back(block->make_stress_recovery(*copies.part, copies.nodes, material_));
  return recoveries;
}
} // namespace chaindrive
