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

void Elastic::move(World       &world,
                   Rim         &rim,
                   const Step  &step,
                   const double kick,
                   const bool   booked,
                   PhaseTimer  &timer)
{
  Copies    &copies         = world.copies[rim.group];
  const auto for_each_batch = [&copies](const auto &visit) {
    for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
         ++batch)
      visit(batch);
  };
  const auto book_sectors =
      [&](const unsigned int batch, const double(&sums)[n_lanes], double &to) {
        if (booked)
          for (unsigned int s = batch; s < copies.n_copies(); s += copies.n_batches())
            to += sums[copies.lane_of(s)];
      };

  for_each_batch([&](const unsigned int batch) {
    alignas(64) Sums sums{};
    add_forces(copies, *references_[rim.group], batch, sums, timer);
    book_sectors(batch, sums.strain, world.ledger.strain);
    book_sectors(batch, sums.hourglass, world.ledger.hourglass);
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
          if (booked)
            world.add_force(rim.body, f, x);
        }
  rim.even_out_forces(copies);

  for_each_batch([&](const unsigned int batch) {
    alignas(64) Sums sums{};
    update(copies, batch, sums, {step.dt, 0., 0.}, kick);
    book_sectors(batch, sums.kinetic, world.ledger.kinetic);
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int s = batch; booked && s < copies.n_copies(); s += copies.n_batches())
        rim.momentum[d] += sums.momentum[d * n_lanes + copies.lane_of(s)];
  });
}
} // namespace chaindrive::element
