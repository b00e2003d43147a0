// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/elastic.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::element
{
Elastic::Elastic(const scene::Scene &scene, const World &world) : kernels_(best_kernels())
{
  for (unsigned int g = 0; g < world.n_elastic_groups(); ++g)
    {
      const BodyBatches &copies = world.copies[g];
      references_.push_back(std::make_unique<Reference>(*copies.part,
                                                        copies.nodes,
                                                        scene.material,
                                                        scene.elements.formulation,
                                                        scene.elements.hourglass_coefficient));
      limits_.push_back({copies.part->name, 2. / references_.back()->largest_frequency()});
    }
}

void Elastic::start(World &world, const Step &step, PhaseTimer &timer)
{
  move(world, step, 0.5 * step.dt, false, timer);
}

void Elastic::advance(World &world, const Step &step, PhaseTimer &timer)
{
  std::vector<BodyBatches::Vector> contact; // which start() will need
  if (step.dt == 0.)
    for (const BodyBatches &copies : world.copies)
      contact.push_back(copies.force);
  move(world, step, step.dt, true, timer);
  for (unsigned int g = 0; g < contact.size(); ++g)
    world.copies[g].force.copy_locally_owned_data_from(contact[g]);
}

void Elastic::move(
    World &world, const Step &step, const double kick, const bool booked, PhaseTimer &timer)
{
  drift_ = step.dt;
  for (unsigned int g = 0; g < references_.size(); ++g)
    {
      const auto rim = std::find_if(
          world.rims.begin(), world.rims.end(), [g](const Rim &r) { return r.group == g; });
      if (rim != world.rims.end())
        {
          move(world, *rim, step, kick, booked);
          continue;
        }
      BodyBatches &copies = world.copies[g];
      for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
           ++batch)
        {
          alignas(64) Sums sums{};
          add_forces(copies, *references_[g], batch, sums, timer);
          update(copies, batch, sums, step, kick);
          if (booked)
            book(world, copies, batch, sums, step);
        }
    }
}

void Elastic::add_forces(BodyBatches       &copies,
                         const Reference   &reference,
                         const unsigned int batch,
                         Sums              &sums,
                         PhaseTimer        &timer) const
{
  const std::size_t first    = copies.start_of(batch);
  double           *force    = copies.force.begin() + first;
  ForceArguments    internal = reference.arguments();
  internal.position          = copies.position.begin() + first;
  internal.force             = force;
  internal.strain_energy     = sums.strain;
  internal.hourglass_energy  = sums.hourglass;
  internal.next              = copies.velocity.begin() + first;
  internal.n_next            = static_cast<unsigned int>(copies.stride());
  {
    const PhaseTimer::Scope scope(timer, internal_force_);
    kernels_.add_internal_forces[static_cast<int>(reference.formulation)](internal);
  }
}

void Elastic::hold_middle_plane(BodyBatches &copies, const unsigned int batch)
{
  double *force = copies.force.begin() + copies.start_of(batch);
  for (const unsigned int node : copies.on_middle_plane)
    std::fill_n(force + (3 * node + 2) * n_lanes, n_lanes, 0.);
}

void Elastic::update(BodyBatches       &copies,
                     const unsigned int batch,
                     Sums              &sums,
                     const Step        &step,
                     const double       kick) const
{
  hold_middle_plane(copies, batch);
  const std::size_t first = copies.start_of(batch);
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

void Elastic::book(World             &world,
                   const BodyBatches &copies,
                   const unsigned int batch,
                   const Sums        &sums,
                   const Step        &step)
{
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    {
      const unsigned int copy = lane * copies.n_batches() + batch;
      if (copy >= copies.n_copies())
        continue;
      const unsigned int body  = copies.bodies[copy];
      Frame             &frame = world.frames[body];
      for (unsigned int d = 0; d < 3; ++d)
        {
          frame.position[d] = sums.first_moment[d * n_lanes + lane] / copies.mass;
          frame.velocity[d] = sums.momentum[d * n_lanes + lane] / copies.mass;
          if (d == 2 && copies.part->half) // of the whole body
            frame.position[d] = frame.velocity[d] = 0.;
          world.displacement.local_element(3 * body + d) =
              frame.position[d] - world.origin[body][d];
          world.velocity.local_element(3 * body + d) = frame.velocity[d];
        }
      // contacts have added their resultants: these complete the force on the centre of mass
      world.force.local_element(3 * body + 1) -= copies.mass * step.gravity;
      for (unsigned int d = 0; d < 3; ++d)
        world.force.local_element(3 * body + d) -= copies.mass * step.drag * frame.velocity[d];
      Ledger &ledger = world.ledger;
      ledger.kinetic += sums.kinetic[lane];
      ledger.strain += sums.strain[lane];
      ledger.hourglass += sums.hourglass[lane];
      ledger.potential +=
          copies.mass * step.gravity * world.displacement.local_element(3 * body + 1);
      ledger.drag += 2. * step.drag * sums.kinetic[lane] * step.dt;
    }
}

dealii::Tensor<1, 3>
Elastic::position(const World &world, const World::Address &place, const unsigned int node) const
{
  const BodyBatches   &copies = world.copies[place.group];
  dealii::Tensor<1, 3> x;
  for (unsigned int d = 0; d < 3; ++d)
    {
      const std::size_t i = copies.index(place.copy, node, d);
      x[d] = copies.position.local_element(i) - drift_ * copies.velocity.local_element(i);
    }
  return x;
}

dealii::Tensor<1, 3> Elastic::displacement(const World          &world,
                                           const World::Address &place,
                                           const unsigned int    node) const
{
  const BodyBatches &copies = world.copies[place.group];
  const Frame       &start  = copies.start[place.copy];
  return position(world, place, node) - start.position -
         start.rotation * dealii::Tensor<1, 3>(copies.nodes.position[node]);
}

std::size_t Elastic::memory_consumption() const
{
  std::size_t bytes = 0;
  for (const auto &reference : references_)
    bytes += reference->memory_consumption();
  return bytes;
}
} // namespace chaindrive::element
