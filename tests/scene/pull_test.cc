// SPDX-License-Identifier: LGPL-2.1-or-later
// Ten links of the layered chain's tight span, pulled: rigid links, with plates and joint contact
// in series in the bush-pin interface, must give the stiffness per pitch that was asked for.
#include "../support/decided.h"
#include "../support/scenes.h"

using namespace test;

namespace
{
/// Where the last link comes to rest under @p force [N], relative to the first, along the chain
/// [m].
double pulled(const scene::Scene &drive, const unsigned int first, const double force)
{
  const unsigned int n = 10, rollers = drive.drive.n_joints;
  scene::Scene       scene = empty_scene();
  scene.loads.drag         = 3e4;
  for (unsigned int i = 0; i < n; ++i)
    scene.bodies.push_back(drive.bodies[rollers + first + i]);
  scene.bodies.front().mass = 1e9; // held
  for (unsigned int d = 0; d < 3; ++d)
    scene.bodies.front().inertia[d] = 1e9;

  scene.bores.push_back({"bush-pin", drive.bores[1].interface, drive.bores[1].law, {}});
  for (scene::BorePair pair : drive.bores[1].pairs)
    {
      pair.master -= rollers + first;
      pair.slave.body -= rollers + first;
      if (pair.master < n && pair.slave.body < n)
        scene.bores[0].pairs.push_back(pair);
    }
  // a long, soft bar pulls with a constant force
  const Vector3 axis = contact::axis_of(scene.bodies.front().initial, 0);
  scene.bodies.push_back(ground());
  scene.bodies[n].initial.position = scene.bodies[n - 1].initial.position + 1e3 * axis;
  scene.bars.push_back({n - 1, n, 0.5e3, force / 0.5e3, 0.});

  dynamics::System system(scene, false);
  advance(system, 20000, 0.25e-6, []() {});
  return (system.world.frames[n - 1].position - system.world.frames[0].position) * axis;
}
} // namespace

int main()
{
  Parameters parameters;
  parameters.model.fidelity               = "layered";
  parameters.output.field_interval        = 0.;
  parameters.model.stiffness_per_pitch    = 3e8;
  parameters.contact.friction_coefficient = 0.;
  const scene::Scene scene                = scene_of(parameters);

  unsigned int first = 0; // an inner link with ten links of the tight span from it on
  for (unsigned int k = 0; k + 11 < scene.drive.n_joints; k += 2)
    if (!scene.drive.seated[k] && !scene.drive.seated[k + 11] &&
        scene.bodies[k].initial.position[1] > 0.)
      first = k;
  const double stretch = pulled(scene, first, 2000.) - pulled(scene, first, 1000.);
  ratio("stiffness per pitch, 9 joints", 9. * 1000. / stretch, 3e8, 5);
}
