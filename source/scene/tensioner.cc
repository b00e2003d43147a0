// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>

namespace chaindrive::scene
{
// The body of an arm or slide has its origin, and the mass of its wheel, at the wheel's centre: its
// inertia about the pivot is that of both, and its weight has the lever of the wheel's.
void add_tensioner(const drive::Drive &drive, Scene &scene)
{
  if (!drive.layout.tensioner)
    return;
  const drive::Tensioner &tensioner = *drive.layout.tensioner;
  Body                   &wheel     = scene.bodies[scene.drive.sprockets[tensioner.wheel].body];
  const auto              number    = static_cast<unsigned int>(scene.bodies.size());
  Body                    body;
  body.kind    = Kind::tensioner;
  body.number  = tensioner.wheel;
  body.motion  = Motion::rigid;
  body.mass    = wheel.mass;
  body.initial = placed(drive.layout.sprockets[tensioner.wheel].centre, 0., {}, 0.);
  int sense    = 1;
  if (tensioner.is_arm())
    {
      Tensor3 z;
      z[2]            = 1.;
      body.mount      = Mount::revolute(z, {tensioner.pivot[0], tensioner.pivot[1], 0.});
      body.inertia[2] = tensioner.inertia;
      sense           = tensioner.sense;
    }
  else
    {
      body.mount =
          Mount::prismatic(dealii::Point<3>(tensioner.direction[0], tensioner.direction[1], 0.));
      body.mass += tensioner.inertia;
    }
  wheel.mount.carrier = number;
  scene.bodies.push_back(body);
  scene.tensioners.push_back({number, tensioner.wheel, sense, tensioner.travel, tensioner.law});
}

void add_swings(const drive::Drive &drive, Scene &scene)
{
  for (const auto &[wheel, swing] : drive.swings)
    {
      const auto number = static_cast<unsigned int>(scene.bodies.size());
      Body       body;
      body.kind        = Kind::tensioner;
      body.number      = wheel;
      body.motion      = Motion::rigid;
      body.mass        = scene.bodies[scene.drive.sprockets[wheel].body].mass;
      body.inertia[2]  = 1.; // of no consequence: nothing turns it but the program
      body.initial     = placed(drive.layout.sprockets[wheel].centre, 0., {}, 0.);
      body.mount       = Mount::motor();
      body.mount.pivot = dealii::Point<3>(swing.pivot[0], swing.pivot[1], 0.);
      scene.bodies[scene.drive.sprockets[wheel].body].mount.carrier = number;
      scene.bodies.push_back(body);
      scene.swings.push_back({number, wheel, swing.angle});
    }
}
} // namespace chaindrive::scene
