// SPDX-License-Identifier: LGPL-2.1-or-later
// What is looked at of strips: of class RollerStrips.
#include <chaindrive/contact/roller_strips.h>

#include <algorithm>
#include <map>

namespace chaindrive::contact
{
double RollerStrips::pressure(const unsigned int unknown, const double force) const
{
  const unsigned int n_rings = flexibility_->n_rings();
  return force / (2. * flexibility_->grid().half_width[unknown / n_rings] * radius_ *
                  length_[unknown % n_rings]);
}

void RollerStrips::raise_pressures(std::vector<double> &largest) const
{
  for (const unsigned int i : own_)
    {
      if (!(states_[i].normal > 0.))
        continue;
      double             &of_joint = largest[records_[i].joint];
      const StripProblem &problem  = rollers_[i].problem; // nothing else has a force
      for (unsigned int k = 0; k < problem.n(); ++k)
        if (problem.force[k] > 0.)
          of_joint = std::max(of_joint, pressure(problem.unknown[k], problem.force[k]));
    }
}

void RollerStrips::add_pressures(const World & /*world*/,
                                 std::vector<NodePressure> &pressures) const
{
  const unsigned int n_rings = flexibility_->n_rings(), n = outside_.n_columns;
  const double       width = 2. * dealii::numbers::PI * radius_ / n;
  for (const unsigned int i : own_)
    for (const Touching &touching : rollers_[i].touching)
      {
        if (touching.strip == not_laid)
          continue; // just restored
        const Strip       &strip = rollers_[i].strips[touching.strip];
        const unsigned int ring  = touching.unknown % n_rings;
        for (unsigned int k = 0; k < n_weights; ++k)
          pressures.push_back({records_[i].slave,
                               node_[ring * n + strip.column[k]],
                               strip.weight[k] * touching.force / (width * length_[ring])});
      }
}

void RollerStrips::add_patches(const World &world, std::vector<PressurePatch> &patches) const
{
  const unsigned int n_rings = flexibility_->n_rings();
  const unsigned int hub     = flanks_->body();
  for (const unsigned int i : own_)
    {
      if (rollers_[i].touching.empty())
        continue;
      // teeth stand where the middle plane of the roller is
      const GapFrame             frame = frame_of_gap(world, i);
      const dealii::Tensor<1, 3> axis  = world.frames[hub].position,
                                 along = world.frames[records_[i].slave].position - axis;
      for (const Touching &touching : rollers_[i].touching)
        {
          const auto &ends   = profile_.strips()[touching.unknown / n_rings].ends;
          const auto &extent = extent_[touching.unknown % n_rings];
          const auto  corner = [&](const unsigned int end, const unsigned int side) {
            return dealii::Point<3>(axis + frame.in_world(ends[end]) +
                                    (along * frame.z + extent[side]) * frame.z);
          };
          patches.push_back({records_[i].slave,
                             hub,
                             records_[i].joint,
                             {{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}},
                             touching.force,
                             pressure(touching.unknown, touching.force)});
        }
    }
}

void RollerStrips::add_massless_forces(const World & /*world*/,
                                       std::vector<NodeForce> &forces) const
{
  const unsigned int n_rings = flexibility_->n_rings(), n = outside_.n_columns;
  for (const unsigned int i : own_)
    {
      const Roller &roller = rollers_[i];
      double        sum    = 0.;
      for (const Touching &touching : roller.touching)
        sum += touching.force;
      const TouchState &state = states_[i]; // friction is shared out as normal forces are
      for (const Touching &touching : roller.touching)
        {
          if (touching.strip == not_laid)
            continue; // just restored
          const Strip               &strip = roller.strips[touching.strip];
          const dealii::Tensor<1, 2> e     = strip.direction;
          const dealii::Tensor<1, 3> of_one =
              -roller.frame.in_world(e) + state.tangential[1] / sum * roller.frame.z -
              state.tangential[0] / sum *
                  roller.frame.in_world(dealii::Tensor<1, 2>({-e[1], e[0]}));
          for (unsigned int k = 0; k < n_weights; ++k)
            forces.push_back({records_[i].slave,
                              node_[touching.unknown % n_rings * n + strip.column[k]],
                              strip.weight[k] * touching.force * of_one});
        }
    }
}
} // namespace chaindrive::contact
