// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/elastic.h>

#include <algorithm>

namespace chaindrive::element
{
void Elastic::follow_hubs(World &world)
{
  for (const Rim &rim : world.rims)
    rim.hold(world.copies[rim.group], world.frames[rim.body]);
}

void Elastic::move(World       &world,
                   const Rim   &rim,
                   const Step  &step,
                   const double kick,
                   const bool   booked,
                   PhaseTimer  &timer)
{
  const Copies                  &copies = world.copies[rim.group];
  dealii::AlignedVector<double> &force  = rim_force_;

  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    {
      alignas(64) Sums sums{};
      add_forces(world, rim.group, batch, force.data() + batch * copies.stride(), sums, timer);
      if (booked)
        for (unsigned int s = batch; s < copies.n_copies(); s += copies.n_batches())
          {
            world.ledger.strain += sums.strain[copies.lane_of(s)];
            world.ledger.hourglass += sums.hourglass[copies.lane_of(s)];
          }
    }

  // the hub takes the forces on the nodes that it holds
  for (unsigned int s = 0; s < copies.n_copies(); ++s)
    for (const unsigned int node : rim.border)
      {
        dealii::Tensor<1, 3> f, x;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const std::size_t i = copies.index(s, node, d);
            x[d]                = copies.position.local_element(i);
            f[d]                = force[i];
            force[i]            = 0.;
          }
        if (booked)
          world.add_force(rim.body, f, x);
      }
  for (const auto &[i, j] : rim.seam)
    for (unsigned int d = 0; d < 3; ++d)
      {
        const double mean      = 0.5 * (force[i + d * n_lanes] + force[j + d * n_lanes]);
        force[i + d * n_lanes] = force[j + d * n_lanes] = mean;
      }

  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    {
      alignas(64) Sums sums{};
      update(world,
             rim.group,
             batch,
             force.data() + batch * copies.stride(),
             sums,
             {step.dt, 0., 0.},
             kick);
      if (booked)
        for (unsigned int s = batch; s < copies.n_copies(); s += copies.n_batches())
          world.ledger.kinetic += sums.kinetic[copies.lane_of(s)];
    }
}
} // namespace chaindrive::element
