// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/elastic.h>

#include <utility>

namespace chaindrive::element
{
void Elastic::follow_hubs(World &world)
{
  for (const Rim &rim : world.rims)
    rim.hold(world.copies[rim.group], world.frames[rim.body]);
}

namespace
{
template <typename Visit>
void for_each_batch(const BodyBatches &copies, const Visit &visit)
{
  for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
       ++batch)
    visit(batch);
}

/// Adds @p sums over the nodes of each sector of @p batch to @p to.
void add_sectors(const BodyBatches &copies,
                 const unsigned int batch,
                 const double (&sums)[n_lanes],
                 double &to)
{
  for (unsigned int s = batch; s < copies.n_copies(); s += copies.n_batches())
    to += sums[copies.lane_of(s)];
}
} // namespace

void Elastic::add_rim_forces(World &world, PhaseTimer &timer) const
{
  for (const Rim &rim : world.rims)
    {
      BodyBatches &copies = world.copies[rim.group];
      for_each_batch(copies, [&](const unsigned int batch) {
        alignas(64) Sums sums{};
        add_forces(copies, *references_[rim.group], batch, sums, timer);
        hold_middle_plane(copies, batch);
        add_sectors(copies, batch, sums.strain, world.ledger.strain);
        add_sectors(copies, batch, sums.hourglass, world.ledger.hourglass);
      });

      // the hub takes the forces on the nodes that it holds
      for (unsigned int s = 0; s < copies.n_copies(); ++s)
        if (copies.owns(s))
          for (const unsigned int node : rim.border)
            {
              const std::size_t    first = copies.index(s, node, 0);
              dealii::Tensor<1, 3> f, x;
              for (unsigned int d = 0; d < 3; ++d)
                {
                  const std::size_t i = first + d * n_lanes;
                  x[d]                = copies.position.local_element(i);
                  f[d]                = std::exchange(copies.force.local_element(i), 0.);
                }
              world.add_force(rim.body, f, x);
            }
      rim.even_out_forces(copies);
    }
}

void Elastic::move(
    World &world, Rim &rim, const Step &step, const double kick, const bool booked) const
{
  BodyBatches &copies = world.copies[rim.group];
  for_each_batch(copies, [&](const unsigned int batch) {
    alignas(64) Sums sums{};
    update(copies, batch, sums, {step.dt, 0., 0.}, kick);
    if (!booked)
      return;
    add_sectors(copies, batch, sums.kinetic, world.ledger.kinetic);
    for (unsigned int s = batch; s < copies.n_copies(); s += copies.n_batches())
      for (unsigned int d = 0; d < 3; ++d)
        rim.momentum[d] += sums.momentum[d * n_lanes + copies.lane_of(s)];
  });
}
} // namespace chaindrive::element
