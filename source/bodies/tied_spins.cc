// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/tied_spins.h>
#include <chaindrive/bodies/world.h>

namespace chaindrive
{
namespace
{
using Vector2 = dealii::Tensor<1, 2>;

/// The difference of an entry of PlanarBodies, else of one that @p of_body returns.
template <typename OfBody>
Vector2 difference(const World       &world,
                   const World::Tied &tied,
                   const PlanarEntry  entry,
                   const OfBody      &of_body)
{
  Vector2 result;
  for (unsigned int d = 0; d < 2; ++d)
    if (world.planar != nullptr)
      {
        const double *value = world.planar->slots().of(entry + d);
        result[d] =
            value[world.planar->slot_of(tied.second)] - value[world.planar->slot_of(tied.first)];
      }
    else
      result[d] = of_body(tied.second, d) - of_body(tied.first, d);
  return result;
}

Vector2 line_of(const World &world, const World::Tied &tied)
{
  return difference(
      world, tied, planar_position, [&world](const unsigned int body, const unsigned int d) {
        return world.frames[body].position[d];
      });
}
} // namespace

void TiedSpins::turn(World &world) const
{
  for (const World::Tied &tied : world.tied)
    {
      const Vector2 line = line_of(world, tied),
                    v    = difference(world,
                                   tied,
                                   planar_velocity,
                                   [&world](const unsigned int body, const unsigned int d) {
                                     return world.velocity.local_element(3 * body + d);
                                   });
      const double speed = (line[0] * v[1] - line[1] * v[0]) / line.norm_square();
      if (world.planar != nullptr)
        world.planar->slots().of(planar_spin)[world.planar->slot_of(tied.body)] = speed;
      else
        world.frames[tied.body].angular_velocity[2] = speed;
    }
}

void TiedSpins::kick(World &world, double /*h*/) { turn(world); }

void TiedSpins::drift(World &world, const Step & /*step*/) { turn(world); }

void TiedSpins::finish(World &world, const Step & /*step*/)
{
  if (world.planar == nullptr) // PlanarBodies hand on what they have
    turn(world);
}

void TiedSpins::gather_forces(World &world)
{
  for (const World::Tied &tied : world.tied)
    {
      double moment = world.moment.local_element(3 * tied.body + 2);
      if (world.planar != nullptr)
        moment += world.planar->slots().of(planar_moment)[world.planar->slot_of(tied.body)];
      if (moment == 0.)
        continue;
      const Vector2 line   = line_of(world, tied);
      const double  factor = moment / line.norm_square();
      Vector2       couple;
      couple[0] = -factor * line[1];
      couple[1] = factor * line[0];
      for (unsigned int d = 0; d < 2; ++d)
        {
          world.force.local_element(3 * tied.second + d) += couple[d];
          world.force.local_element(3 * tied.first + d) -= couple[d];
        }
    }
}
} // namespace chaindrive
