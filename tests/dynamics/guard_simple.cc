// SPDX-License-Identifier: LGPL-2.1-or-later
// The simple drive at full speed, with one thing wrong: it must be stopped within 100 steps, and
// the message must name the place.
#include "../support/faults.h"
#include "../support/scenes.h"

#include <limits>

using namespace test;

namespace
{
Vector3 pull(const System &system, const unsigned int bar)
{
  const scene::Bar &b = system.bars.bars()[bar];
  const Vector3     between =
      system.world.frames[b.second].position - system.world.frames[b.first].position;
  return system.bars.tension()[bar] / between.norm() * between;
}

/// Whether two lumps on a bar that fly and fall with drag are left alone.
bool falls_soundly(const bool planar)
{
  scene::Scene scene  = empty_scene();
  scene.planar        = planar;
  scene.bodies        = {lump(0.01, Vector3(), vector(3., 1.)),
                         lump(0.01, vector(0.01, 0.), vector(3., 1.))};
  scene.bars          = {{0, 1, 0.01, 1e6, 0.}};
  scene.loads.gravity = 9.81;
  scene.loads.drag    = 20.;
  System             system(scene, false);
  const double       limit = system.critical_time_step(), dt = 0.2 * limit;
  dynamics::Guard    guard(scene, system, 0.05, limit);
  dynamics::Services services(system);
  try
    {
      for (unsigned int i = 1; i <= 1000; ++i)
        {
          system.advance_without_update(dt, i * dt);
          guard.observe(system, i, dt, services);
        }
    }
  catch (const dynamics::Fault &)
    {
      return false;
    }
  return guard.largest_momentum_error() > 0.;
}

const std::string roller(const unsigned int k) { return "roller " + std::to_string(k); }
} // namespace

int main()
{
  const scene::Scene scene = drive_scene("prm/paper/simple.prm", {"Drive/Layout/Start=settled"});
  const double part  = 0.43e-6 / System(scene, false).critical_time_step(); // the faults need time
  const auto   sound = [&scene, part]() { return Drive(scene, 2000, part); };
  const std::string momentum = "Momentum", lost = "as if it did not get the force of the ",
                    sign = "as if it got the wrong sign of the force of the ";

  for (const unsigned int bar : {5U, 60U}) // of the tight and of the slack span
    {
      const std::string at = " (bar " + std::to_string(bar) + ")";
      const std::string name =
          "bar between " + roller(bar) + " and " + roller((bar + 1) % scene.drive.n_joints);
      sound().expect_stop("bar pulls at one end only" + at,
                          {momentum, roller(bar) + ":", lost + name},
                          [bar](System &s) { push(s, s.bars.bars()[bar].first, -pull(s, bar)); });
      sound().expect_stop(
          "bar pushes at one end" + at,
          {momentum, roller(bar) + ":", sign + name},
          [bar](System &s) { push(s, s.bars.bars()[bar].first, -2. * pull(s, bar)); });
      sound().expect_stop(
          "bar pushes at both ends" + at, {"energy", sign + name}, [bar](System &s) {
            push(s, s.bars.bars()[bar].first, -2. * pull(s, bar));
            push(s, s.bars.bars()[bar].second, 2. * pull(s, bar));
          });
    }

  for (const std::string teeth : {"roller-driver", "roller-driven"})
    {
      Drive      drive = sound();
      const auto found = drive.most_loaded(teeth);
      const auto i     = found.second;
      const auto force = [teeth, i](System &s) -> const contact::Record & {
        return families_called(teeth, s)[0]->records()[i];
      };
      const std::string place =
          "interface " + teeth + " at joint " + std::to_string(force(drive.system).joint);
      drive.expect_stop(teeth + " without reaction", {momentum, lost + place}, [&](System &s) {
        push(s, force(s).master, force(s).force);
      });
      sound().expect_stop(teeth + " acts on the sprocket only",
                          {momentum, lost + place},
                          [&](System &s) { push(s, force(s).slave, -force(s).force); });
      sound().expect_stop(teeth + " has the wrong sign on the roller",
                          {momentum, sign + place},
                          [&](System &s) { push(s, force(s).slave, -2. * force(s).force); });
      sound().expect_stop(teeth + " pulls", {"energy", place}, [&](System &s) {
        push(s, force(s).slave, -2. * force(s).force);
        push(s, force(s).master, 2. * force(s).force);
      });
    }

  sound().expect_stop("one roller weighs nothing", {momentum, roller(40) + ":"}, [](System &s) {
    Vector3 weight;
    weight[1] = s.world.mass[40] * s.loads.gravity();
    push(s, 40, weight);
  });

  // what drag has taken follows from where bodies have got to
  verdict("bodies that fall with drag go on, in space", falls_soundly(false));
  verdict("  and in the plane", falls_soundly(true));
  const scene::Scene slowed =
      drive_scene("prm/paper/simple.prm", {"Drive/Layout/Start=settled", "Loads/Drag in 1/s=20"});
  Drive(slowed, 2000, part)
      .expect_stop("bar pulls at one end only, with drag",
                   {momentum, roller(5) + ":"},
                   [](System &s) { push(s, s.bars.bars()[5].first, -pull(s, 5)); });

  // of sticking contacts with friction the limit is lower, but they slide before they blow up
  const scene::Scene smooth = drive_scene(
      "prm/paper/simple.prm", {"Drive/Layout/Start=settled", "Contact/Friction coefficient=0"});
  Drive(smooth, 2000, 0.08)
      .expect_stop("step 1.3 times the limit", {"nergy", "roller"}, {}, {}, 1.3 / 0.08);

  Drive broken = sound();
  set_velocity(broken.system, 17, 0, std::numeric_limits<double>::quiet_NaN());
  broken.expect_stop(
      "a velocity is not a number", {"not a number", "Where: roller 17 (position)"}, {});
}
