// SPDX-License-Identifier: LGPL-2.1-or-later
// The layered drive at full speed, with one thing wrong in its joints: it must be stopped within
// 100 steps, and the message must name the place.
#include "../support/faults.h"

#include <chaindrive/contact/geometry.h>

#include <limits>

using namespace test;

namespace
{
/// Adds @p times the force of pair @p i of the interface called @p name once more, on the slave, on
/// the master, or on both.
void add_again(System             &system,
               const scene::Scene &scene,
               const std::string  &name,
               const unsigned int  i,
               const double        on_slave,
               const double        on_master)
{
  const contact::Record &record = families_called(name, system)[0]->records()[i];
  for (const scene::BoreFamily &bores : scene.bores)
    if (bores.name == name)
      {
        const scene::SlavePoint &slave = bores.pairs[i].slave;
        const Vector3 at = contact::to_world(system.world.frames[slave.body], slave.point) -
                           slave.radius * record.normal;
        system.world.add_force(record.slave, on_slave * record.force, at);
        system.world.add_force(record.master, -on_master * record.force, at);
      }
}
} // namespace

int main()
{
  const scene::Scene scene = drive_scene("prm/paper/layered.prm", {"Drive/Layout/Start=settled"});
  const auto         sound = [&scene]() { return Drive(scene, 2000, 0.08); };

  for (const std::string name : {"bush-pin", "roller-bush"})
    {
      Drive                  drive  = sound();
      const unsigned int     i      = drive.most_loaded(name).second;
      const contact::Record &record = families_called(name, drive.system)[0]->records()[i];
      const std::string      place =
          "interface " + name + " at joint " + std::to_string(record.joint) + " (";
      const auto fault = [&](const double on_slave, const double on_master) {
        return [&scene, name, i, on_slave, on_master](System &s) {
          add_again(s, scene, name, i, on_slave, on_master);
        };
      };
      drive.expect_stop(name + " without reaction",
                        {"Momentum", "as if it did not get the force of the " + place},
                        fault(0., -1.));
      sound().expect_stop(name + " acts on the bore only",
                          {"Momentum", "as if it did not get the force of the " + place},
                          fault(-1., 0.));
      sound().expect_stop(name + " has the wrong sign on the bore",
                          {"Momentum", "as if it got the wrong sign of the force of the " + place},
                          fault(0., -2.));
      sound().expect_stop(name + " pulls", {"nergy", place}, fault(-2., -2.));
    }

  // not all contacts are closed: 1.3 times as much does not yet blow up within 100 steps
  sound().expect_stop("step 1.6 times the limit", {"nergy", "Where: "}, {}, {}, 1.6 / 0.08);

  Drive broken = sound();
  set_velocity(broken.system, 17, 1, std::numeric_limits<double>::quiet_NaN());
  broken.expect_stop(
      "a velocity is not a number", {"not a number", "Where: roller 17 (position)"}, {});
  Drive spins = sound();
  for (World::Rotation &rotation : spins.system.world.rotations)
    if (rotation.body == 17)
      rotation.momentum[2] = std::numeric_limits<double>::quiet_NaN();
  if (const PlanarBodies *planar = spins.system.world.planar)
    planar->slots().of(planar_spin)[planar->slot_of(17)] = std::numeric_limits<double>::quiet_NaN();
  spins.expect_stop("a spin is not a number", {"not a number", "Where: roller 17 (spin)"}, {});
}
