// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/shaft.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace chaindrive::scene
{
namespace
{
/// A body at the centre of sprocket @p i, which it turns or carries.
Body on_shaft(const drive::Drive &drive, const Kind kind, const unsigned int i)
{
  Body body;
  body.kind    = kind;
  body.number  = i;
  body.motion  = Motion::rigid;
  body.mass    = drive.sprockets[i].solid.mass;
  body.initial = placed(drive.layout.sprockets[i].centre, 0., {}, 0.);
  return body;
}

/// What is behind the coupling of sprocket @p i gets its shaft: a motor turns as the program says,
/// a machine with the inertia that the sprocket does not have, against its torque.
void add_machine(const drive::Drive &drive, const unsigned int i, Scene &scene)
{
  const drive::Sprocket &sprocket = drive.sprockets[i];
  const drive::Coupling &coupling = *sprocket.coupling;
  const auto             number   = static_cast<unsigned int>(scene.bodies.size());
  const unsigned int     wheel    = scene.drive.sprockets[i].body;
  const bool             motor    = sprocket.role == parameters::Role::driver;
  Body                   body     = on_shaft(drive, Kind::machine, i);
  // the inertia of a motor with a given speed changes nothing
  body.inertia[2] = motor ? coupling.before : coupling.behind;
  body.mount      = motor ? Mount::motor() : Mount::revolute();
  // above its resonance a machine keeps its mean speed, whatever the sprocket does
  const drive::Layout::Sprocket &start = drive.layout.sprockets[i];
  const drive::Layout::Sprocket &first = drive.layout.sprockets[0];
  const double                   mean =
      start.turn * first.speed * drive.sprockets[0].form.teeth / sprocket.form.teeth;
  const double tooth = std::abs(first.speed) * drive.sprockets[0].form.teeth;
  body.initial.angular_velocity[2] =
      motor || tooth < 2. * dealii::numbers::PI * coupling.frequency() ? start.speed : mean;
  scene.bodies.push_back(body);
  for (Shaft &shaft : scene.shafts)
    if (shaft.body == wheel)
      shaft.body = number;
  scene.drive.sprockets[i].shaft = number;
  const int sense                = scene.drive.sprockets[i].sense;
  scene.couplings.push_back({i,
                             wheel,
                             number,
                             motor ? -sense : sense,
                             coupling.stiffness,
                             coupling.damping,
                             start.torque});
  scene.notes.push_back(
      "Coupling of the " + sprocket.title + ": " + to_text(coupling.stiffness, 4) +
      " N m/rad and " + to_text(coupling.damping, 4) + " N m s/rad between the inertias " +
      to_text(coupling.before, 4) + " kg m2" +
      (motor ? " and that of a motor with a given speed" :
               " and " + to_text(coupling.behind, 4) + " kg m2") +
      ", which vibrate with " + to_text(coupling.frequency(), 4) + " Hz without the chain");
}

/// Two bodies of the whole mass, of which the second one moves on the first one.
void add_bearing(const drive::Drive &drive, const unsigned int i, Scene &scene)
{
  const drive::Sprocket &sprocket = drive.sprockets[i];
  const drive::Bearing  &given    = *sprocket.bearing;
  Bearing                bearing{};
  bearing.sprocket = i;
  bearing.weight   = given.mass * scene.loads.gravity;
  for (unsigned int d = 0; d < 2; ++d)
    {
      dealii::Tensor<1, 3> axis;
      axis[d]              = 1.;
      bearing.bodies[d]    = static_cast<unsigned int>(scene.bodies.size());
      bearing.stiffness[d] = given.stiffness[d];
      bearing.damping[d]   = given.damping[d];
      bearing.start[d]     = drive.layout.sprockets[i].deflection[d];
      Body body            = on_shaft(drive, Kind::bearing, i);
      body.mass            = given.mass;
      body.mount           = Mount::prismatic(axis);
      if (d == 1)
        body.mount.carrier = bearing.bodies[0];
      scene.bodies.push_back(body);
    }
  scene.bodies[scene.drive.sprockets[i].body].mount.carrier = bearing.bodies[1];
  scene.bearings.push_back(bearing);
  const bool same = given.stiffness[0] == given.stiffness[1];
  scene.notes.push_back(
      "Bearing of the " + sprocket.title + ": " + to_text(given.stiffness[0], 4) + " N/m" +
      (same ? "" : " along x, " + to_text(given.stiffness[1], 4) + " along y") + ", " +
      to_text(given.damping[0], 4) + " N s/m" +
      (same ? "" : " and " + to_text(given.damping[1], 4)) + ", " + to_text(given.mass, 4) +
      " kg, which vibrate with " + to_text(given.frequency(0), 4) +
      (same ? "" : " and " + to_text(given.frequency(1), 4)) + " Hz without the chain");
}
} // namespace

void add_shafts(const drive::Drive &drive, Scene &scene)
{
  for (unsigned int i = 0; i < drive.sprockets.size(); ++i)
    {
      if (drive.sprockets[i].coupling)
        add_machine(drive, i, scene);
      if (drive.sprockets[i].bearing)
        add_bearing(drive, i, scene);
    }
}
} // namespace chaindrive::scene
