// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/rigid_bodies.h>
#include <chaindrive/bodies/turning.h>
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

/// Turns one body on, as turn() does several.
void turn(World::Rotation &rotation, Frame &frame, const double dt)
{
  // midpoint: the angular velocity where the body will be after half the step
  const Quaternion half =
      rotation_by(0.5 * dt * angular_velocity(rotation, frame.rotation)) * rotation.orientation;
  frame.angular_velocity = angular_velocity(rotation, to_matrix(half));
  rotation.orientation =
      normalized(rotation_by(dt * frame.angular_velocity) * rotation.orientation);
  frame.rotation = to_matrix(rotation.orientation);
}

/// Calls @p use(lane, rotation, frame) for those of @p world from number @p first on, as many as
/// there are lanes.
template <typename Use>
void for_each_lane(World &world, const std::size_t first, const Use &use)
{
  for (unsigned int lane = 0; lane < n_lanes && first + lane < world.rotations.size(); ++lane)
    {
      World::Rotation &rotation = world.rotations[first + lane];
      use(lane, rotation, world.frames[rotation.body]);
    }
}

/// The bodies from number @p first on; lanes beyond the last one have what they had.
void load_lanes(World &world, const std::size_t first, Turning &bodies)
{
  for_each_lane(
      world, first, [&](const unsigned int lane, const auto &rotation, const auto &frame) {
        for (unsigned int d = 0; d < 3; ++d)
          {
            bodies.momentum[d][lane] = rotation.momentum[d];
            bodies.inertia[d][lane]  = rotation.inertia[d];
            for (unsigned int e = 0; e < 3; ++e)
              bodies.rotation[3 * d + e][lane] = frame.rotation[d][e];
          }
        const Quaternion &q         = rotation.orientation;
        bodies.orientation[0][lane] = q.w;
        bodies.orientation[1][lane] = q.x;
        bodies.orientation[2][lane] = q.y;
        bodies.orientation[3][lane] = q.z;
      });
}

void give_angular_velocity(const Turning &bodies, const unsigned int lane, Frame &frame)
{
  for (unsigned int d = 0; d < 3; ++d)
    frame.angular_velocity[d] = bodies.angular_velocity[d][lane];
}

/// Bodies that do not turn, for lanes without one.
Turning at_rest()
{
  Turning bodies{};
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    {
      bodies.orientation[0][lane] = 1.;
      for (unsigned int d = 0; d < 3; ++d)
        bodies.inertia[d][lane] = bodies.rotation[4 * d][lane] = 1.;
    }
  return bodies;
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

  Turning bodies = at_rest();
  for (std::size_t first = 0; first < world.rotations.size(); first += n_lanes)
    {
      load_lanes(world, first, bodies);
      if (!turn(bodies, step.dt))
        for_each_lane(world, first, [&](unsigned int, auto &rotation, auto &frame) {
          turn(rotation, frame, step.dt);
        });
      else
        for_each_lane(world, first, [&](const unsigned int lane, auto &rotation, auto &frame) {
          const auto &q        = bodies.orientation;
          rotation.orientation = {q[0][lane], q[1][lane], q[2][lane], q[3][lane]};
          give_angular_velocity(bodies, lane, frame);
          for (unsigned int d = 0; d < 3; ++d)
            for (unsigned int e = 0; e < 3; ++e)
              frame.rotation[d][e] = bodies.rotation[3 * d + e][lane];
        });
    }
  set_velocities(world);
}

void RigidBodies::finish(World &world, const Step & /*step*/)
{
  Turning bodies = at_rest();
  for (std::size_t first = 0; first < world.rotations.size(); first += n_lanes)
    {
      load_lanes(world, first, bodies);
      find_angular_velocity(bodies);
      for_each_lane(world, first, [&](const unsigned int lane, auto &, auto &frame) {
        give_angular_velocity(bodies, lane, frame);
      });
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
