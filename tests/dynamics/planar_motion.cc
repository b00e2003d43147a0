// SPDX-License-Identifier: LGPL-2.1-or-later
// Drives whose bodies move in the plane against the same in space: positions, velocities, forces,
// energies and the chain's records agree to round-off until impacts amplify it; the step limit is
// the same.
#include "../support/decided.h"
#include "../support/scenes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace test;

namespace
{
Parameters drive_of(const std::string &fidelity, const parameters::Start start)
{
  Parameters p;
  p.model.fidelity                 = fidelity;
  p.drive.n_links                  = 34;
  p.drive.sprockets.driver().teeth = 11;
  p.drive.sprockets.driven().teeth = 13;
  p.drive.layout.slack             = 1e-4;
  p.drive.layout.start             = start;
  p.model.driven_inertia           = 1e-3;
  p.loads.resisting_torque         = 40.;
  p.loads.ramp_time                = 1e-4;
  p.loads.gravity                  = 9.81;
  p.loads.drag                     = 30.;
  p.model.chain_damping_ratio      = 0.02;
  return p;
}

/// Largest difference of two systems: lengths over a pitch, speeds over that of the chain, forces
/// over the tension of the load, energies over the kinetic one at full speed.
double difference(const dynamics::System &a,
                  const dynamics::System &b,
                  const double            pitch,
                  const double            speed,
                  const double            force,
                  const double            energy)
{
  double     largest = 0.;
  const auto look    = [&largest](const double x, const double y, const double scale) {
    largest = std::max(largest, std::abs(x - y) / scale);
  };
  for (unsigned int i = 0; i < a.world.n_bodies(); ++i)
    {
      const Frame &f = a.world.frames[i], &g = b.world.frames[i];
      for (unsigned int d = 0; d < 3; ++d)
        {
          look(f.position[d], g.position[d], pitch);
          look(f.velocity[d], g.velocity[d], speed);
          look(f.angular_velocity[d], g.angular_velocity[d], speed / pitch);
          look(a.world.force.local_element(3 * i + d),
               b.world.force.local_element(3 * i + d),
               force);
          look(a.world.velocity.local_element(3 * i + d),
               b.world.velocity.local_element(3 * i + d),
               speed);
          look(a.world.displacement.local_element(3 * i + d),
               b.world.displacement.local_element(3 * i + d),
               pitch);
          for (unsigned int e = 0; e < 3; ++e)
            look(f.rotation[d][e], g.rotation[d][e], 1.);
        }
    }
  for (double Ledger::*term : Ledger::added)
    look(a.world.ledger.*term, b.world.ledger.*term, energy);
  look(a.world.ledger.drive_work, b.world.ledger.drive_work, energy);
  look(a.world.ledger.resisting_work, b.world.ledger.resisting_work, energy);
  for (std::size_t f = 0; f < a.contacts.families().size(); ++f)
    for (std::size_t i = 0; i < a.contacts.families()[f]->records().size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        look(a.contacts.families()[f]->records()[i].force[d],
             b.contacts.families()[f]->records()[i].force[d],
             force);
  for (unsigned int i = 0; i < a.bars.size(); ++i)
    look(a.bars.tension()[i], b.bars.tension()[i], force);
  return largest;
}

void compare(const std::string &name, const Parameters &parameters, const unsigned int n)
{
  scene::Scene scene = scene_of(parameters);
  verdict(name + ", auto: in the plane", scene.planar);
  dynamics::System planar(scene, false);
  scene.planar = false;
  dynamics::System spatial(scene, false);
  verdict("  bodies move in the plane, or not",
          planar.world.planar != nullptr && spatial.world.planar == nullptr);
  verdict("  the same step limit to 1e-12",
          std::abs(planar.critical_time_step() / spatial.critical_time_step() - 1.) < 1e-12);
  const double dt = 0.1 * spatial.critical_time_step();
  for (unsigned int i = 1; i <= n; ++i)
    {
      planar.advance(dt, i * dt);
      spatial.advance(dt, i * dt);
    }
  const scene::Sprocket &driver = scene.drive.driver();
  const double           speed  = parameters.loads.driver_speed * driver.pitch_radius,
               force  = parameters.loads.resisting_torque / scene.drive.driven().pitch_radius,
               energy = scene.nominal_energy();
  double fastest      = 0.;
  for (const Frame &frame : planar.world.frames)
    fastest = std::max(fastest, frame.velocity.norm());
  verdict("  the chain runs at its speed", fastest > 0.9 * speed);
  const double differs = difference(planar, spatial, scene.drive.pitch, speed, force, energy);
  verdict("  they agree to 1e-9", differs < 1e-9);
  if (differs >= 1e-9)
    std::cout << "  " << differs << '\n';
}
} // namespace

int main()
{
  for (const auto &[name, fidelity] :
       {std::make_pair("simple", "simple"), std::make_pair("layered", "layered")})
    for (const parameters::Start start : {parameters::Start::taut, parameters::Start::settled})
      compare(
          std::string(name) + ", " + parameters::text_of(start), drive_of(fidelity, start), 1500);
}
