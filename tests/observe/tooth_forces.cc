// SPDX-License-Identifier: LGPL-2.1-or-later
// A roller that is pressed into one gap of a sprocket and then, from one step to the next, into
// another: the force moves with it. What the histories say of the first gap is no longer true.
#include "../support/scenes.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/elastic_flanks.h>
#include <chaindrive/contact/point_contact.h>
#include <chaindrive/observe/tooth_forces.h>

using namespace test;

int main()
{
  scene::Scene scene = empty_scene();
  const auto   chain = drive::make_chain(parameters::Chain());
  const auto   form  = std::make_shared<const drive::ToothForm>(
      drive::make_tooth_form(15, chain, parameters::Sprockets(), 0));
  const double radius = 0.5 * chain.roller_diameter, depth = 1e-6,
               seated = 0.5 * form->root_diameter + radius - depth;
  scene.bodies        = {lump(0.01, vector(seated, 0.)), ground()};

  scene::ToothFamily family;
  family.name         = "roller-driver";
  family.sprocket     = 1;
  family.form         = form;
  family.teeth        = 15;
  family.outer_radius = 0.5 * form->outside_diameter;
  family.half_width   = 3.6e-3;
  family.law          = {1e8, 0., 0., 0., 0.};
  family.slaves       = {{0, dealii::Point<3>(), radius, 0}};

  World                 world = make_world(scene);
  contact::PointContact teeth(contact::on_flanks(family, world));
  observe::ToothForces  forces("driver", 1, 15);
  forces.families = {&teeth};
  for (const unsigned int gap : {0U, 1U})
    {
      const double angle       = gap * form->pitch_angle();
      world.frames[0].position = vector(seated * std::cos(angle), seated * std::sin(angle));
      world.clear_forces();
      teeth.search(world, 1e-3);
      teeth.add_forces(world, 1e-6);
      forces.update();
      std::cout << "pressed into gap " << gap << ": forces / N in the first three gaps";
      for (unsigned int g = 0; g < 3; ++g)
        std::cout << ' ' << std::fixed << std::setprecision(3) << forces.in_gap[g];
      std::cout << ", on the roller " << forces.roller[0] << '\n';
    }
  std::cout << "largest since the sample before " << forces.in_gap_peak[0] << ' '
            << forces.in_gap_peak[1] << ' ' << forces.in_gap_peak[2] << '\n';
}
