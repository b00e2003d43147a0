// SPDX-License-Identifier: LGPL-2.1-or-later
// A roller is thrown out of the seat of a sprocket, so far that the search leaves it out, and falls
// back: rigid and elastic, it is met again when and as fast as gravity says, nothing is missed, and
// the energy closes.
#include "../support/scenes.h"

#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>

using namespace test;

namespace
{
constexpr double gravity = 500., thrown = 5.; // m/s2, m/s

scene::Scene make_scene(const bool elastic)
{
  scene::Scene scene  = empty_scene();
  scene.loads.gravity = gravity;
  const auto chain    = drive::make_chain(parameters::Chain());
  const auto form     = std::make_shared<const drive::ToothForm>(
      drive::make_tooth_form(15, chain, parameters::Sprockets(), 0));
  const auto part = std::make_shared<const mesh::Part>(
      mesh::make_roller(chain, scene.material.density, mesh::RollerGrid(1, 16, 2)));
  scene.parts[scene::Kind::roller] = part;

  const double start               = 0.5 * form->root_diameter + 0.5 * chain.roller_diameter + 5e-6;
  scene.bodies                     = {body(elastic ? scene::Motion::elastic : scene::Motion::rigid,
                                           scene::Mount::free(),
                                           part->meshed.mass,
                                           vector(part->meshed.inertia[0][0],
                              part->meshed.inertia[1][1],
                              part->meshed.inertia[2][2]),
                                           vector(0., start),
                                           vector(0., thrown)),
                                      ground()};
  scene.bodies[1].initial.rotation = to_matrix(rotation_about_z(0.5 * dealii::numbers::PI));

  scene::ToothFamily family;
  family.name          = "roller-driver";
  family.sprocket      = 1;
  family.form          = form;
  family.teeth         = 15;
  family.outer_radius  = 0.5 * form->outside_diameter;
  family.half_width    = 3.6e-3;
  family.elastic       = elastic;
  family.slave_surface = mesh::roller_outside;
  family.slaves        = {{0, dealii::Point<3>(), 0.5 * chain.roller_diameter, 0}};
  family.law.stiffness = elastic ? 1e14 : 2e7; // per area, N/m
  scene.teeth          = {family};
  return scene;
}
} // namespace

int main()
{
  for (const bool elastic : {false, true})
    {
      const scene::Scene scene = make_scene(elastic);
      dynamics::System   system(scene, false);
      const auto        &family =
          dynamic_cast<const contact::SurfaceContact &>(*system.contacts.families()[0]);
      const World &world = system.world;
      const double mass  = world.mass[0];
      const double dt    = std::min(0.25 * system.critical_time_step(), 0.2e-6);
      double       worst = 0., touched = 0., speed = 0.;
      bool         left_out = false;
      advance(system, static_cast<unsigned long>(22e-3 / dt), dt, [&]() {
        worst    = std::max(worst, std::abs(world.ledger.imbalance()));
        left_out = left_out || family.near().empty();
        if (touched == 0. && family.n_touching() > 0)
          {
            touched = world.time;
            speed   = world.frames[0].velocity[1];
          }
      });
      std::cout << (elastic ? "elastic\n" : "rigid\n");
      verdict("  left out by the search", left_out);
      ratio("  time of its return", touched, 2. * thrown / gravity, 3);
      ratio("  speed then", speed, -thrown, 2);
      verdict("  flies off again", world.frames[0].velocity[1] > 0.5 * thrown);
      verdict("  no contact missed", system.contacts.n_missed() == 0);
      verdict("  imbalance below 0.1 % of the energy", worst < 1e-3 * 0.5 * mass * thrown * thrown);
    }
}
