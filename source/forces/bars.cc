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

bool Bars::reads_frames(const World &world) const
{
  return world.planar == nullptr ||
         std::any_of(bars_.begin(), bars_.end(), [&world](const scene::Bar &bar) {
           return world.planar->slot_of(bar.first) == PlanarBodies::none ||
                  world.planar->slot_of(bar.second) == PlanarBodies::none;
         });
}

void Bars::make_runs(const PlanarBodies &bodies)
{
  for (unsigned int i = 0; i < bars_.size(); ++i)
    {
      const unsigned int first  = bodies.slot_of(bars_[i].first),
                         second = bodies.slot_of(bars_[i].second);
      if (runs_.empty() || first != runs_.back().first + runs_.back().n ||
          second != runs_.back().second + runs_.back().n)
        runs_.push_back({first, second, i, 0, {}});
      ++runs_.back().n;
    }
  for (Run &run : runs_)
    {
      const unsigned int n = n_computed_of(run.n);
      run.numbers.resize(6 * n, 0.);
      for (unsigned int i = 0; i < run.n; ++i)
        {
          const scene::Bar &bar  = bars_[run.begin + i];
          run.numbers[i]         = bar.length;
          run.numbers[n + i]     = bar.stiffness;
          run.numbers[2 * n + i] = bar.damping;
          run.numbers[4 * n + i] = length_[run.begin + i];
          run.numbers[5 * n + i] = viscous_[run.begin + i];
        }
    }
}

void Bars::add_in_plane(World &world, const double dt)
{
  if (runs_.empty())
    make_runs(*world.planar);
  for (Run &run : runs_)
    {
      const unsigned int n       = n_computed_of(run.n);
      double            *numbers = run.numbers.begin();
      PlanarBars         bars{run.first,
                      run.second,
                      n,
                      numbers,
                      numbers + n,
                      numbers + 2 * n,
                      numbers + 3 * n,
                      numbers + 4 * n,
                      numbers + 5 * n,
                      0.,
                      0.};
      world.planar->kernels().stretch(world.planar->slots(), bars);
      std::copy_n(bars.tension, run.n, tension_.begin() + run.begin);
      world.ledger.bar += bars.energy;
      if (dt > 0.)
        world.ledger.chain_damping += bars.loss;
    }
}

void Bars::add_forces(World &world, const double dt)
{
  if (!runs_.empty() || !reads_frames(world))
    return add_in_plane(world, dt);
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
  for (const Run &run : runs_) // which have what the last evaluation found
    {
      const double *numbers = run.numbers.begin();
      std::copy_n(numbers + 4 * n_computed_of(run.n), run.n, length_.begin() + run.begin);
      std::copy_n(numbers + 5 * n_computed_of(run.n), run.n, viscous_.begin() + run.begin);
    }
  if (archive.reads())
    runs_.clear(); // to be made of what comes now
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
