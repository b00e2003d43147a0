// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/bushing.h>

namespace chaindrive
{
Bushing::Bushing(const unsigned int          first,
                 const unsigned int          second,
                 const dealii::Point<3>     &at,
                 const dealii::Tensor<1, 3> &stiffness,
                 const dealii::Tensor<1, 3> &damping)
    : bodies_{{first, second}}, at_(at), stiffness_(stiffness), damping_(damping)
{
}

std::unique_ptr<ForceElement> Bushing::clone() const { return std::make_unique<Bushing>(*this); }

dealii::Tensor<1, 3> Bushing::place_of(const World &world, const unsigned int i) const
{
  const Frame &frame = world.frames[bodies_[i]];
  return frame.position + frame.rotation * point_[i];
}

void Bushing::add_forces(World &world, const double dt)
{
  if (!placed_) // the first call is that of the start
    for (unsigned int i = 0; i < 2; ++i)
      {
        const Frame &start = world.frames[bodies_[i]];
        point_[i]          = transpose(start.rotation) * (at_ - start.position);
      }
  placed_ = true;
  dealii::Tensor<1, 3> place[2], velocity[2];
  for (unsigned int i = 0; i < 2; ++i)
    {
      const Frame               &frame = world.frames[bodies_[i]];
      const dealii::Tensor<1, 3> arm   = frame.rotation * point_[i];
      place[i]                         = frame.position + arm;
      velocity[i] = frame.velocity + cross_product_3d(frame.angular_velocity, arm);
    }
  const dealii::Tensor<1, 3> way = place[0] - place[1];
  dealii::Tensor<1, 3>       elastic, viscous;
  for (unsigned int d = 0; d < 3; ++d)
    {
      elastic[d] = stiffness_[d] * way[d];
      viscous[d] = damping_[d] * (velocity[0] - velocity[1])[d];
    }
  // both act where the first point is, so that they cancel in force and moment
  for (unsigned int i = 0; i < 2; ++i)
    {
      const dealii::Tensor<1, 3> force =
          world.symmetry.share(i == 0 ? -1. : 1.) * (elastic + viscous);
      const dealii::Tensor<1, 3> moment =
          cross_product_3d(place[0] - world.frames[bodies_[i]].position, force);
      for (unsigned int d = 0; d < 3; ++d)
        {
          world.force.local_element(3 * bodies_[i] + d) += force[d];
          world.moment.local_element(3 * bodies_[i] + d) += moment[d];
        }
    }
  world.ledger.spring += world.symmetry.share(0.5 * (elastic * way));
  if (dt > 0.)
    world.ledger.spring_damping +=
        world.symmetry.share(0.5 * ((viscous_ + viscous) * (way - way_)));
  way_     = way;
  viscous_ = viscous;
  force_   = elastic + viscous;
}

std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>> Bushing::forces() const
{
  return {{bodies_[0], -force_}, {bodies_[1], force_}};
}

void Bushing::add_springs(const World &world, std::vector<Spring> &springs) const
{
  for (unsigned int d = 0; d < 3; ++d)
    {
      dealii::Tensor<1, 3> direction;
      direction[d] = 1.;
      springs.push_back({bodies_[0],
                         bodies_[1],
                         direction,
                         place_of(world, 0),
                         place_of(world, 1),
                         stiffness_[d],
                         damping_[d]});
    }
}

void Bushing::serialize(const Archive &archive)
{
  archive("way", way_);
  archive("viscous", viscous_);
}
} // namespace chaindrive
