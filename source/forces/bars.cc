// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/bars.h>

#include <algorithm>
#include <cmath>

namespace chaindrive
{
Bars::Bars(const std::vector<scene::Bar> &bars)
    : bars_(bars), tension_(bars.size(), 0.), viscous_(bars.size(), 0.)
{
  for (const scene::Bar &bar : bars_)
    length_.push_back(bar.length);
}

void Bars::add_forces(World &world, const double dt)
{
  double  strain_energy = 0., loss = 0.;
  double *force = world.force.begin();
  for (unsigned int i = 0; i < bars_.size(); ++i)
    {
      const scene::Bar          &bar     = bars_[i];
      const Frame               &first   = world.frames[bar.first];
      const Frame               &second  = world.frames[bar.second];
      const dealii::Tensor<1, 3> between = second.position - first.position;
      const double               length  = between.norm();
      const dealii::Tensor<1, 3> axis    = between / length;
      const double               rate    = axis * (second.velocity - first.velocity);
      const double               elastic = bar.stiffness * (length - bar.length);
      const double               viscous = bar.damping * rate;

      tension_[i] = elastic + viscous;
      for (unsigned int d = 0; d < 3; ++d)
        {
          force[3 * bar.first + d] += tension_[i] * axis[d];
          force[3 * bar.second + d] -= tension_[i] * axis[d];
        }

      strain_energy += 0.5 * elastic * (length - bar.length);
      if (dt > 0.)
        loss += 0.5 * (viscous_[i] + viscous) * (length - length_[i]);
      viscous_[i] = viscous;
      length_[i]  = length;
    }
  world.ledger.bar += strain_energy;
  world.ledger.chain_damping += loss;
}

void Bars::serialize(const Archive &archive)
{
  archive.numbers("tension", tension_);
  archive.numbers("length", length_);
  archive.numbers("viscous", viscous_);
}

void Bars::add_springs(const World &world, std::vector<Spring> &springs) const
{
  for (const scene::Bar &bar : bars_)
    {
      const dealii::Tensor<1, 3> &from = world.frames[bar.first].position;
      const dealii::Tensor<1, 3> &to   = world.frames[bar.second].position;
      springs.push_back({bar.first,
                         bar.second,
                         (to - from) / (to - from).norm(),
                         from,
                         to,
                         bar.stiffness,
                         bar.damping});
    }
}
} // namespace chaindrive
