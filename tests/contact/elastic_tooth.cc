// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic roller on the elastic teeth of a sprocket. Undeformed teeth give the forces of a rigid
// sprocket, displaced and turned ones those of a rigid one displaced and turned with them; on
// strained ones the force is the derivative of the contact's energy. Forces cancel in sum and
// moment. A roller pressed into its seat from 5 um above it keeps its energy, and
// with soft contact springs, under which nothing else yields, its force is that of a rigid
// sprocket. What pushes the tip of a tooth, where two sectors meet, pushes both alike. A point of a
// rigid roller is near however far along the axis it is.
#include "../support/tooth.h"

#include <chaindrive/contact/point_contact.h>

using namespace test;

namespace
{
void check_between_sectors()
{
  const scene::Scene scene = make_scene(Tooth());
  dynamics::System   system(scene, false);
  World             &world  = system.world;
  const Rim         &rim    = world.rims[0];
  BodyBatches       &copies = world.copies[rim.group];
  const double       angle  = dealii::numbers::PI / scene.teeth[0].teeth;
  const double       radius = scene.teeth[0].outer_radius;
  const auto         flanks = contact::make_flanks(scene.teeth[0], world);
  const Vector3      tip    = vector(radius * std::cos(angle), radius * std::sin(angle), 1e-3);
  contact::Surface::Projection projection;
  unsigned int                 hint  = 0;
  const contact::Touch         touch = flanks->project(world, tip, 0., 1e-3, hint, projection);
  world.clear_forces();
  const Vector3       push = vector(-3., 2., 1.);
  contact::PointForce on_slave{};
  on_slave.total = -push;
  flanks->add_opposite(world, tip, touch, projection, on_slave);

  Vector3 sum;
  for (unsigned int s = 0; s < copies.n_copies(); ++s)
    for (unsigned int node = 0; node < copies.n_nodes(); ++node)
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += NodeView(copies.force).component(copies.index(s, node), d);
  bool         alike    = true;
  unsigned int n_pushed = 0;
  for (const auto &[v, w] : rim.sector->seam)
    for (unsigned int s = 0; s < copies.n_copies(); ++s)
      {
        const auto   i = copies.index(s, copies.nodes.of_vertex[v]);
        const auto   j = copies.index((s + 1) % copies.n_copies(), copies.nodes.of_vertex[w]);
        const double a = copies.force.local_element(i), b = copies.force.local_element(j);
        alike = alike && a == b;
        n_pushed += a != 0. ? 1 : 0;
      }
  verdict("a push between two sectors is one on both", alike && n_pushed == 2);
  verdict("and no more than it is", (sum - push).norm() < 1e-12);
}

void check_far_along_the_axis()
{
  scene::Scene       scene  = make_scene(Tooth());
  scene::ToothFamily family = scene.teeth[0];
  family.elastic            = false;
  family.half_width         = 0.1;
  family.slaves[0].point    = dealii::Point<3>(0., 0., 0.09); // the teeth are 41 mm from the axis
  dynamics::System      system(scene, false);
  contact::PointContact teeth(contact::on_flanks(family, system.world));
  std::vector<Spring>   springs;
  teeth.search(system.world, family.slaves[0].radius);
  teeth.add_springs(system.world, springs);
  verdict("a point of a roller 90 mm along the axis is near", !springs.empty());
}
} // namespace

int main()
{
  check_geometry(Sprocket::generated);
  check_balance(Sprocket::generated);
  check_between_sectors();
  check_far_along_the_axis();

  Tooth elastic, rigid;
  rigid.elastic         = false;
  const Outcome pressed = press(elastic), on_rigid = press(rigid);
  verdict("imbalance below 0.5 % of the energy", pressed.worst < 5e-3);
  std::cout << "peak force over that on a rigid sprocket: " << std::fixed << std::setprecision(1)
            << pressed.peak / on_rigid.peak << "; rebound at " << pressed.speed << " of the speed, "
            << on_rigid.speed << " from a rigid one\n";

  elastic.softness = rigid.softness = 1e-3;
  const Outcome soft = press(elastic), soft_rigid = press(rigid);
  verdict("soft springs: peak force and impulse of a rigid sprocket to 1 %",
          std::abs(soft.peak / soft_rigid.peak - 1.) < 1e-2 &&
              std::abs(soft.impulse / soft_rigid.impulse - 1.) < 1e-2);
}
