// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/rigid_bodies.h>
#include <chaindrive/bodies/world.h>

namespace chaindrive
{
namespace
{
/// w = R I^-1 R^T L.
dealii::Tensor<1, 3> angular_velocity(const World::Rotation      &rotation,
                                      const dealii::Tensor<2, 3> &matrix)
{
  dealii::Tensor<1, 3> in_body = dealii::transpose(matrix) * rotation.momentum;
  for (unsigned int d = 0; d < 3; ++d)
    in_body[d] /= rotation.inertia[d];
  return matrix * in_body;
}

void set_velocities(World &world)
{
  const double *v = world.velocity.begin();
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    for (unsigned int d = 0; d < 3; ++d)
      world.frames[b].velocity[d] = v[3 * b + d];
  for (const World::Spin &spin : world.spins)
    world.frames[spin.body].angular_velocity[2] = spin.speed;
}
} // namespace

void RigidBodies::kick(World &world, const double h)
{
  double       *v = world.velocity.begin();
  const double *f = world.force.begin();
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    for (unsigned int d = 0; d < 3; ++d)
      v[3 * b + d] += h * world.inverse_mass[b] * f[3 * b + d];

  const double *moment = world.moment.begin();
  for (World::Rotation &rotation : world.rotations)
    for (unsigned int d = 0; d < 3; ++d)
      rotation.momentum[d] += h * moment[3 * rotation.body + d];
  for (World::Spin &spin : world.spins)
    spin.speed += h / spin.inertia * moment[3 * spin.body + 2];
}

void RigidBodies::drift(World &world, const Step &step)
{
  double       *u = world.displacement.begin();
  const double *v = world.velocity.begin();
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    for (unsigned int d = 0; d < 3; ++d)
      {
        u[3 * b + d] += step.dt * v[3 * b + d];
        world.frames[b].position[d] = world.origin[b][d] + u[3 * b + d];
      }

  for (World::Rotation &rotation : world.rotations)
    {
      Frame &frame = world.frames[rotation.body];
      // midpoint: the angular velocity where the body will be after half the step
      const Quaternion half =
          rotation_by(0.5 * step.dt * angular_velocity(rotation, frame.rotation)) *
          rotation.orientation;
      frame.angular_velocity = angular_velocity(rotation, to_matrix(half));
      rotation.orientation =
          normalized(rotation_by(step.dt * frame.angular_velocity) * rotation.orientation);
      frame.rotation = to_matrix(rotation.orientation);
    }
  set_velocities(world);
}

void RigidBodies::finish(World &world, const Step & /*step*/)
{
  for (World::Rotation &rotation : world.rotations)
    {
      Frame &frame           = world.frames[rotation.body];
      frame.angular_velocity = angular_velocity(rotation, frame.rotation);
    }
  set_velocities(world);
}

double RigidBodies::kinetic_energy(const World &world) const
{
  double energy = 0.;
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (world.inverse_mass[b] > 0.)
      energy += 0.5 * world.mass[b] * world.frames[b].velocity.norm_square();
  for (const World::Rotation &r : world.rotations)
    energy += 0.5 * (r.momentum * world.frames[r.body].angular_velocity);
  for (const World::Spin &spin : world.spins)
    energy += 0.5 * spin.inertia * spin.speed * spin.speed;
  return energy;
}
} // namespace chaindrive
