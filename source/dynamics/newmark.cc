// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/newmark.h>

namespace chaindrive::dynamics
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

/// v += dt/2 f/m and L += dt/2 M for all that is free, and the same for loaded hubs.
void kick(World &world, const double half)
{
  double       *v = world.velocity.begin();
  const double *f = world.force.begin();
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    for (unsigned int d = 0; d < 3; ++d)
      v[3 * b + d] += half * world.inverse_mass[b] * f[3 * b + d];

  const double *moment = world.moment.begin();
  for (World::Rotation &rotation : world.rotations)
    for (unsigned int d = 0; d < 3; ++d)
      rotation.momentum[d] += half * moment[3 * rotation.body + d];
  for (World::Spin &spin : world.spins)
    spin.speed += half / spin.inertia * moment[3 * spin.body + 2];
  for (World::Hub &hub : world.hubs)
    if (!hub.prescribed)
      hub.speed += half / hub.inertia * moment[3 * hub.body + 2];
}

void set_velocities(World &world)
{
  const double *v = world.velocity.begin();
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    for (unsigned int d = 0; d < 3; ++d)
      world.frames[b].velocity[d] = v[3 * b + d];
  for (const World::Spin &spin : world.spins)
    world.frames[spin.body].angular_velocity[2] = spin.speed;
  for (const World::Hub &hub : world.hubs)
    world.frames[hub.body].angular_velocity[2] = hub.speed;
}
} // namespace

void first_half(World                    &world,
                const load::SpeedProgram *program,
                const double              dt,
                const double              new_time)
{
  kick(world, 0.5 * dt);

  double       *u = world.displacement.begin();
  const double *v = world.velocity.begin();
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    for (unsigned int d = 0; d < 3; ++d)
      {
        u[3 * b + d] += dt * v[3 * b + d];
        world.frames[b].position[d] = world.origin[b][d] + u[3 * b + d];
      }

  for (World::Rotation &rotation : world.rotations)
    {
      Frame &frame = world.frames[rotation.body];
      // midpoint: the angular velocity where the body will be after half the step
      const Quaternion half =
          rotation_by(0.5 * dt * angular_velocity(rotation, frame.rotation)) * rotation.orientation;
      frame.angular_velocity = angular_velocity(rotation, to_matrix(half));
      rotation.orientation =
          normalized(rotation_by(dt * frame.angular_velocity) * rotation.orientation);
      frame.rotation = to_matrix(rotation.orientation);
    }

  for (World::Hub &hub : world.hubs)
    {
      if (hub.prescribed && program != nullptr)
        {
          hub.angle = program->angle(new_time);
          hub.speed = program->speed(new_time - 0.5 * dt);
        }
      else
        hub.angle += dt * hub.speed;
      world.frames[hub.body].rotation = to_matrix(rotation_about_z(hub.start_angle + hub.angle));
    }
  set_velocities(world);
  world.time = new_time;
}

void second_half(World &world, const load::SpeedProgram *program, const double dt)
{
  kick(world, 0.5 * dt);
  for (World::Rotation &rotation : world.rotations)
    {
      Frame &frame           = world.frames[rotation.body];
      frame.angular_velocity = angular_velocity(rotation, frame.rotation);
    }
  for (World::Hub &hub : world.hubs)
    if (hub.prescribed && program != nullptr)
      hub.speed = program->speed(world.time);
  set_velocities(world);
}

void accelerations(const World &world, std::vector<double> &result)
{
  result.resize(3 * world.n_bodies());
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    {
      const bool   elastic = world.elastic_address[b].group != World::Address::none;
      const double inverse = elastic ? 1. / world.mass[b] : world.inverse_mass[b];
      for (unsigned int d = 0; d < 3; ++d)
        result[3 * b + d] = inverse * world.force.local_element(3 * b + d);
    }
}
} // namespace chaindrive::dynamics
