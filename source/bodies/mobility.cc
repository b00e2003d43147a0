// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/mobility.h>

#include <utility>

namespace chaindrive
{
Mobility::Mobility(const World &world)
    : world_(world), inverse_inertia_(world.n_bodies()), pivot_(world.n_bodies())
{
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    pivot_[b] = world.frames[b].position;
  for (const World::Rotation &rotation : world.rotations)
    {
      const dealii::Tensor<2, 3> &r = world.frames[rotation.body].rotation;
      dealii::Tensor<2, 3>        diagonal;
      for (unsigned int d = 0; d < 3; ++d)
        diagonal[d][d] = 1. / rotation.inertia[d];
      inverse_inertia_[rotation.body] = r * diagonal * dealii::transpose(r);
    }
  for (const World::Spin &spin : world.spins)
    inverse_inertia_[spin.body][2][2] = 1. / spin.inertia;
  for (const World::Tied &tied : world.tied)
    {
      const dealii::Tensor<1, 3> line = pivot_[tied.second] - pivot_[tied.first];
      inverse_inertia_[tied.body][2][2] =
          (world.inverse_mass[tied.first] + world.inverse_mass[tied.second]) / line.norm_square();
    }
  for (const World::Hub &hub : world.hubs)
    {
      if (hub.slides)
        continue;
      pivot_[hub.body] = world.pivot_of(hub);
      if (!hub.prescribed)
        inverse_inertia_[hub.body] = 1. / hub.inertia * outer_product(hub.axis, hub.axis);
    }
  for (const World::Carried &c : world.carried)
    pivot_[c.body] = world.frames[c.body].position;
}

dealii::Tensor<1, 3> Mobility::lever_of(const World::Tied &tied) const
{
  const dealii::Tensor<1, 3> line = pivot_[tied.second] - pivot_[tied.first];
  dealii::Tensor<1, 3>       lever;
  lever[0] = -line[1];
  lever[1] = line[0];
  return lever / line.norm_square();
}

void Mobility::accelerate(std::vector<dealii::Tensor<1, 3>> &force,
                          std::vector<dealii::Tensor<1, 3>> &moment) const
{
  for (auto c = world_.carried.rbegin(); c != world_.carried.rend(); ++c)
    {
      force[c->carrier] += force[c->body];
      moment[c->carrier] += cross_product_3d(pivot_[c->body] - pivot_[c->carrier], force[c->body]);
    }
  for (const World::Tied &tied : world_.tied)
    {
      const dealii::Tensor<1, 3> lever = lever_of(tied), couple = moment[tied.body][2] * lever;
      force[tied.second] += couple;
      force[tied.first] -= couple;
    }
  std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>> sliding;
  for (const World::Hub &hub : world_.hubs)
    if (hub.slides)
      sliding.emplace_back(hub.body, (hub.axis * force[hub.body]) / hub.inertia * hub.axis);
  for (unsigned int body = 0; body < world_.n_bodies(); ++body)
    {
      force[body] *= world_.inverse_mass[body];
      moment[body] = inverse_inertia_[body] * moment[body];
    }
  for (const World::Tied &tied : world_.tied)
    {
      moment[tied.body]    = dealii::Tensor<1, 3>();
      moment[tied.body][2] = lever_of(tied) * (force[tied.second] - force[tied.first]);
    }
  for (const auto &[body, acceleration] : sliding)
    force[body] = acceleration;
  for (const World::Carried &c : world_.carried)
    {
      const dealii::Tensor<1, 3> own = c.slides ? force[c.body] : dealii::Tensor<1, 3>();
      force[c.body]                  = force[c.carrier] +
                      cross_product_3d(moment[c.carrier], pivot_[c.body] - pivot_[c.carrier]) + own;
    }
}

dealii::Tensor<2, 3> Mobility::of_point(const unsigned int          body,
                                        const dealii::Tensor<1, 3> &at) const
{
  const dealii::Tensor<1, 3> arm = at - pivot_[body];
  dealii::Tensor<2, 3>       cross; // cross * w = w x arm
  cross[0][1]                 = arm[2];
  cross[1][0]                 = -arm[2];
  cross[1][2]                 = arm[0];
  cross[2][1]                 = -arm[0];
  cross[2][0]                 = arm[1];
  cross[0][2]                 = -arm[1];
  dealii::Tensor<2, 3> result = cross * inverse_inertia_[body] * dealii::transpose(cross);
  for (unsigned int d = 0; d < 3; ++d)
    result[d][d] += world_.inverse_mass[body];
  for (const World::Carried &c : world_.carried)
    if (c.body == body)
      result += of_point(c.carrier, pivot_[body]);
  for (const World::Hub &hub : world_.hubs)
    if (hub.slides && hub.body == body)
      result += 1. / hub.inertia * outer_product(hub.axis, hub.axis);
  return result;
}
} // namespace chaindrive
