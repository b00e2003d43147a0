// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/load/loads.h>
#include <chaindrive/scene/scene.h>

namespace chaindrive::load
{
Loads::Loads(const scene::Scene &scene)
    : start_(scene.start_time), gravity_(scene.loads.gravity), drag_(scene.loads.drag)
{
  for (const scene::Shaft &shaft : scene.shafts)
    if (scene.bodies[shaft.body].mount.kind != scene::Mount::Kind::fixed)
      shafts_.push_back({shaft});
  for (const scene::Swing &swing : scene.swings)
    shafts_.push_back({{swing.body, 1, {}}, swing.angle});
}

void Loads::add_forces(World &world, const double dt)
{
  const double share = world.symmetry.share(1.); // sum_over_ranks() makes it whole
  if (world.planar != nullptr && (gravity_ != 0. || drag_ != 0.))
    {
      const PlanarLoads loads = world.planar->add_loads(gravity_, drag_);
      world.ledger.potential += loads.potential;
      world.ledger.drag += loads.power * dt;
    }
  else if (gravity_ != 0.)
    for (unsigned int b = 0; b < world.n_bodies(); ++b)
      if (world.inverse_mass[b] > 0.)
        {
          const double weight = share * world.mass[b] * gravity_;
          world.force.local_element(3 * b + 1) -= weight;
          world.ledger.potential += weight * world.displacement.local_element(3 * b + 1);
        }
  if (gravity_ != 0.) // the pivot bears the weight itself, which is no force on the chain
    for (const World::Hub &hub : world.hubs)
      if (!hub.prescribed && hub.arm.norm_square() > 0.)
        {
          const double               weight = world.symmetry.share(world.mass[hub.body] * gravity_);
          const dealii::Tensor<1, 3> arm    = world.frames[hub.body].position - world.pivot_of(hub);
          world.moment.local_element(3 * hub.body) += arm[2] * weight;
          world.moment.local_element(3 * hub.body + 2) -= arm[0] * weight;
          world.ledger.potential += weight * (arm - hub.arm)[1];
        }
  if (gravity_ != 0.)
    for (const World::Hub &hub : world.hubs)
      if (hub.slides)
        {
          const double weight = world.symmetry.share(world.mass[hub.body] * gravity_);
          world.force.local_element(3 * hub.body + 1) -= weight;
          world.ledger.potential += weight * hub.angle * hub.axis[1];
        }
  if (drag_ != 0. && world.planar == nullptr)
    for (unsigned int b = 0; b < world.n_bodies(); ++b)
      if (world.inverse_mass[b] > 0.)
        {
          const dealii::Tensor<1, 3> &v    = world.frames[b].velocity;
          const double                drag = share * drag_ * world.mass[b];
          for (unsigned int d = 0; d < 3; ++d)
            world.force.local_element(3 * b + d) -= drag * v[d];
          world.ledger.drag += drag * v.norm_square() * dt;
        }
}

void Loads::serialize(const Archive &archive)
{
  for (State &shaft : shafts_)
    {
      const Archive part = archive / std::to_string(shaft.given.body);
      part("torque", shaft.torque);
      part("angle", shaft.angle);
    }
  archive("booked", booked_);
}

double Loads::prescribed_angle(const unsigned int body, const double time) const
{
  const State *shaft = find(body);
  if (shaft != nullptr && shaft->turn)
    return shaft->turn->value(time) - shaft->turn->value(start_);
  return shaft == nullptr || !shaft->given.program.speed ?
             0. :
             shaft->given.sense * shaft->given.program.speed->integral(start_, time);
}

double Loads::prescribed_speed(const unsigned int body, const double time) const
{
  const State *shaft = find(body);
  if (shaft != nullptr && shaft->turn)
    return shaft->turn->derivative(time);
  return shaft == nullptr || !shaft->given.program.speed ?
             0. :
             shaft->given.sense * shaft->given.program.speed->value(time);
}

const Loads::State *Loads::find(const unsigned int body) const
{
  for (const State &shaft : shafts_)
    if (shaft.given.body == body)
      return &shaft;
  return nullptr;
}

double Loads::torque(const unsigned int body) const
{
  const State *shaft = find(body);
  return shaft == nullptr ? 0. : shaft->torque;
}

void Loads::add_work(World &world)
{
  // trapezoidal rule over the step that ended now: both torques belong to its two ends
  for (const World::Hub &hub : world.hubs)
    for (State &shaft : shafts_)
      if (shaft.given.body == hub.body)
        {
          const double sense  = shaft.given.sense;
          const double torque = hub.prescribed ?
                                    -world.moment_about(hub) : // supplied against the contacts
                                    -sense * shaft.given.program.resisting_torque(
                                                 sense * hub.angle, world.time, sense * hub.speed);
          const double work   = 0.5 * (shaft.torque + torque) * (hub.angle - shaft.angle);
          if (booked_ && hub.prescribed)
            world.ledger.drive_work += work;
          else if (booked_)
            world.ledger.resisting_work -= work;
          shaft.torque = torque;
          shaft.angle  = hub.angle;
          if (!hub.prescribed)
            for (unsigned int d = 0; d < 3; ++d)
              world.moment.local_element(3 * hub.body + d) += torque * hub.axis[d];
        }
  booked_ = true;
}
} // namespace chaindrive::load
