// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/load/loads.h>
#include <chaindrive/scene/scene.h>

namespace chaindrive::load
{
Loads::Loads(const scene::Scene &scene)
    : programs_(scene.programs)
    , start_(scene.start_time)
    , gravity_(scene.loads.gravity)
    , drag_(scene.loads.drag)
    , sense_(scene.sense)
{
}

void Loads::add_forces(World &world, const double dt)
{
  const double share = world.symmetry.share(1.); // sum_over_ranks() makes it whole
  if (gravity_ != 0.)
    for (unsigned int b = 0; b < world.n_bodies(); ++b)
      if (world.inverse_mass[b] > 0.)
        {
          const double weight = share * world.mass[b] * gravity_;
          world.force.local_element(3 * b + 1) -= weight;
          world.ledger.potential += weight * world.displacement.local_element(3 * b + 1);
        }
  if (drag_ != 0.)
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
  archive("drive torque", drive_torque_);
  archive("load torque", load_torque_);
  archive("drive angle", drive_angle_);
  archive("load angle", load_angle_);
  archive("booked", booked_);
}

void Loads::add_work(World &world)
{
  // trapezoidal rule over the step that ended now: both torques belong to its two ends
  for (const World::Hub &hub : world.hubs)
    {
      double &moment = world.moment.local_element(3 * hub.body + 2);
      if (hub.prescribed)
        {
          const double torque = -moment; // supplied against the contacts
          if (booked_)
            world.ledger.drive_work += 0.5 * (drive_torque_ + torque) * (hub.angle - drive_angle_);
          drive_torque_ = torque;
          drive_angle_  = hub.angle;
        }
      else
        {
          const double torque =
              -sense_ * programs_.resisting_torque(sense_ * hub.angle, world.time);
          if (booked_)
            world.ledger.resisting_work -=
                0.5 * (load_torque_ + torque) * (hub.angle - load_angle_);
          load_torque_ = torque;
          load_angle_  = hub.angle;
          moment += torque;
        }
    }
  booked_ = true;
}
} // namespace chaindrive::load
