// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of rigid bodies across their axes. A body between two flat faces bounces like a mass on a
// spring; it rubs with Coulomb's friction; just below the limit of the step it vibrates without
// growing, just above it explodes. The side of a tooth is where a drawing has it, and its normal is
// the gradient of the distance. Whatever the state, forces and moments cancel.
#include "../support/scenes.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/tooth_side.h>

#include <random>

using namespace test;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
constexpr double mass = 0.01, k = 1e7, width = 8e-3, play = 0.2e-3; // kg, N/m, m, m

/// A block 2 * play narrower than the @p width between the faces of a body that stands still.
scene::Scene block_between_faces(const double mu, const Vector3 &velocity)
{
  scene::Scene scene = empty_scene();
  scene.bodies       = {ground(),
                        body(scene::Motion::rigid,
                       scene::Mount::free(),
                       mass,
                       vector(1e-6, 1e-6, 1e-6),
                       Vector3(),
                       velocity)};
  scene::SideFamily sides{"faces", scene::Interface::other, {k, 0., mu, mu > 0. ? k : 0., 0.}, {}};
  for (const int side : {-1, 1})
    sides.pairs.push_back(
        {0, 0.5 * side * width, -side, {1, Point<3>(0., 0., side * (0.5 * width - play)), 0., 0}});
  scene.sides.push_back(sides);
  return scene;
}

void bounce()
{
  const double     v = 0.5, contact = PI * std::sqrt(mass / k);
  dynamics::System system(block_between_faces(0., vector(0., 0., v)), false);
  const double     dt       = contact / 1000.;
  double           touching = 0., deepest = 0.;
  // it flies play, touches, and flies back through the middle to the other side
  advance(system, static_cast<unsigned long>((play / v + 1.5 * contact) / dt), dt, [&]() {
    const contact::Record &record = system.contacts.families()[0]->records()[1];
    touching += record.gap < 0. ? dt : 0.;
    deepest = std::max(deepest, -record.gap);
  });
  ratio("time of a bounce", touching, contact, 2);
  ratio("deepest", deepest, v * std::sqrt(mass / k));
  ratio("speed after it", system.world.frames[1].velocity[2], -v);
}

void rub()
{
  // pressed by the middle of its bounce it slows down by mu times the impulse of the face
  const double     v = 0.1, across = 1., mu = 0.2;
  dynamics::System system(block_between_faces(mu, vector(across, 0., v)), false);
  const double     dt = PI * std::sqrt(mass / k) / 1000.;
  advance(system, static_cast<unsigned long>((play / v) / dt) + 1500, dt, []() {});
  ratio("change of the speed across by friction, over that of a block that slides all the time",
        across - system.world.frames[1].velocity[0],
        mu * 2. * v,
        2);
  const Ledger &ledger = system.world.ledger;
  ratio("energy lost and kept",
        ledger.friction + ledger.kinetic,
        0.5 * mass * (across * across + v * v));
}

/// Closed on both sides, with springs also across: the frequency of the block.
void limit()
{
  scene::Scene scene = block_between_faces(0., vector(0., 0., 1e-3));
  for (scene::SidePair &pair : scene.sides[0].pairs)
    pair.slave.point[2] += (pair.slave.point[2] > 0. ? 1. : -1.) * (play + 1e-5);
  scene.start_overlap   = 2e-5;
  const double critical = dynamics::System(scene, false).critical_time_step();
  ratio("critical step", critical, 2. / std::sqrt(2. * k / mass));
  for (const double share : {0.99, 1.01})
    {
      dynamics::System system(scene, false);
      double           largest = 0.;
      advance(system, 400, share * critical, [&]() {
        largest = std::max(largest, std::abs(system.world.frames[1].position[2]));
      });
      std::cout << "  with " << share << " of it the block "
                << (largest < 1e-5 ? "vibrates" : "is thrown about") << '\n';
    }
}

scene::ToothSideFamily tooth_sides()
{
  scene::ToothSideFamily sides;
  sides.name       = "sides";
  sides.sprocket   = 0;
  sides.half_width = 3.6e-3;
  sides.tip_radius = 80e-3;
  sides.relief     = 1.65e-3;
  sides.radius     = 12.7e-3;
  sides.law        = {k, 10., 0.3, 0.8 * k, 10.};
  return sides;
}

void shape()
{
  scene::Scene scene = empty_scene();
  scene.bodies       = {ground()};
  // leans, stands off and is turned
  scene.bodies[0].initial.position = vector(0.01, -0.02, 0.003);
  scene.bodies[0].initial.rotation =
      to_matrix(rotation_by(vector(0.02, -0.03, 0.)) * rotation_about_z(1.));
  const Frame                  frame  = scene.bodies[0].initial;
  const World                  world  = make_world(scene);
  const scene::ToothSideFamily family = tooth_sides();
  const contact::ToothSide     side(family, 1), other(family, -1);
  unsigned int                 hint = 0;
  contact::Surface::Projection projection;
  const auto                   at = [&](const double r, const double angle, const double z) {
    return frame.position + frame.rotation * vector(r * std::cos(angle), r * std::sin(angle), z);
  };
  const auto project = [&](const contact::Surface &surface, const Vector3 &x) {
    return surface.project(world, x, 0., 0., hint, projection);
  };
  const double gap = 0.1e-3;
  ratio("gap below the rounding", project(side, at(70e-3, 0.3, family.half_width + gap)).gap, gap);
  ratio("on the other side", project(other, at(70e-3, 0.3, -family.half_width - gap)).gap, gap);
  // at the tip the surface stands back by the relief
  const double on_tip =
      project(side, at(family.tip_radius, 2., family.half_width - family.relief)).gap;
  verdict("at the tip it stands back by the relief", std::abs(on_tip) < 1e-12);
  double worst = 0.;
  for (const double r : {60e-3, 74e-3, 76e-3, 79e-3, 80.5e-3})
    {
      const Vector3        x     = at(r, 1., family.half_width - 1.9e-3);
      const contact::Touch touch = project(side, x);
      if (touch.gap >= 0.)
        continue;
      for (unsigned int d = 0; d < 3; ++d)
        {
          Vector3 e;
          e[d]              = 1e-7;
          const double rise = (project(side, x + e).gap - project(side, x - e).gap) / 2e-7;
          worst             = std::max(worst, std::abs(rise - touch.normal[d]));
        }
      worst = std::max({worst,
                        std::abs(touch.normal * touch.along),
                        std::abs(touch.along.norm() - 1.),
                        std::abs(touch.across.norm() - 1.)});
    }
  verdict("normals are gradients of the distance, tangents across them", worst < 1e-6);
}

void cancel()
{
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> any(-1., 1.);
  const auto                             random = [&](const double s) {
    Vector3 numbers; // one after the other: compilers evaluate arguments in orders of their own
    for (unsigned int d = 0; d < 3; ++d)
      numbers[d] = s * any(generator);
    return numbers;
  };
  double       worst_force = 0., worst_moment = 0.;
  unsigned int touching = 0;
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      scene::Scene scene = empty_scene();
      for (unsigned int b = 0; b < 2; ++b)
        {
          const Vector3 position = random(1e-4), velocity = random(1.);
          scene.bodies.push_back(body(scene::Motion::rigid,
                                      scene::Mount::free(),
                                      1.,
                                      vector(1., 1., 1.),
                                      position,
                                      velocity));
          scene.bodies[b].initial.rotation         = to_matrix(rotation_by(random(0.02)));
          scene.bodies[b].initial.angular_velocity = random(100.);
        }
      scene::ToothSideFamily sides = tooth_sides();
      for (const double z : {-3.55e-3, 3.55e-3})
        for (const double x : {70e-3, 75e-3})
          sides.slaves.push_back({1, Point<3>(x, 0., z), 0., 0});
      scene.tooth_sides.push_back(sides);
      scene.sides.push_back({"faces",
                             scene::Interface::other,
                             sides.law,
                             {{0, 5e-3, 1, {1, Point<3>(0.01, 0., 5e-3), 0., 0}}}});
      World             world = make_world(scene);
      contact::Contacts contacts(scene, world, false);
      contacts.add_forces(world, 1e-7);
      Vector3 force, moment;
      double  size = 0.;
      for (unsigned int b = 0; b < 2; ++b)
        {
          Vector3 f, m;
          for (unsigned int d = 0; d < 3; ++d)
            {
              f[d] = world.force.local_element(3 * b + d);
              m[d] = world.moment.local_element(3 * b + d);
            }
          force += f;
          moment += m + dealii::cross_product_3d(world.frames[b].position, f);
          size += f.norm();
        }
      if (size == 0.)
        continue;
      ++touching;
      worst_force  = std::max(worst_force, force.norm() / size);
      worst_moment = std::max(worst_moment, moment.norm() / (size * 0.1));
    }
  std::cout << "touching in " << touching << " of 200 states\n";
  verdict("sum of forces below 1e-15 of their size", worst_force < 1e-15);
  verdict("sum of moments below 1e-14 of force times 10 cm", worst_moment < 1e-14);
}
} // namespace

int main()
{
  bounce();
  rub();
  limit();
  shape();
  cancel();
}
