// SPDX-License-Identifier: LGPL-2.1-or-later
// An inner link of finite elements on a straight guide, which the edges of its plates touch. Down a
// slope it slides with the acceleration g sin a - mu F / m and presses with F = m g cos a, by which
// the guide deflects. One that comes along a guide from beyond its end, lower than the guide by a
// part of the height of its plates, is lifted by the end: no energy comes from nothing.
#include "../support/scenes.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/path/curve.h>

using namespace test;
using dealii::Point;

namespace
{
constexpr double slope = 0.5, g = 1e4, mu = 0.1, k = 1e7;

/// A link whose eyes are @p above [m] the line that slopes down from the origin by @p angle, the
/// middle of it at @p along [m], and a guide on that line.
scene::Scene link_on_guide(const double angle, const double along, const double above)
{
  const parameters::Material steel;
  const auto                 chain = drive::make_chain(parameters::Chain());
  scene::Scene               scene = empty_scene();
  mesh::Part    part = mesh::make_inner_link(chain, steel.density, mesh::inner_link_grid(0));
  const Vector3 down = vector(std::cos(angle), -std::sin(angle)),
                up   = vector(std::sin(angle), std::cos(angle));

  scene::Body link       = body(scene::Motion::elastic,
                          scene::Mount::free(),
                          part.meshed.mass,
                          Vector3(),
                          along * down + (0.5 * chain.inner_plate_height + above) * up);
  link.kind              = scene::Kind::inner_link;
  link.initial.rotation  = to_matrix(rotation_about_z(-angle));
  scene.parts[link.kind] = std::make_shared<const mesh::Part>(std::move(part));
  scene.bodies           = {link,
                            body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), {})};

  scene::GuideFamily guide;
  guide.name  = "guide";
  guide.body  = 1;
  guide.curve = std::make_shared<const path::Curve>(
      path::Curve::spline({Point<2>(), Point<2>(0.2 * std::cos(angle), -0.2 * std::sin(angle))}));
  guide.law       = {1e14, 3e6, mu, 0.7e14, 2e6};
  guide.slaves    = {{0, Point<3>(), 0.5 * (chain.pitch + chain.inner_plate_height), 0}};
  guide.elastic   = true;
  guide.stiffness = k;
  guide.depth     = 0.5 * chain.inner_plate_height;
  scene.guides    = {guide};
  return scene;
}

void slide()
{
  constexpr double above = 1e-9;
  scene::Scene     scene = link_on_guide(slope, 0.05, above);
  scene.loads.gravity    = g;
  dynamics::System system(scene, false);
  const World     &world = system.world;
  const Vector3    down  = vector(std::cos(slope), -std::sin(slope)),
                up       = vector(std::sin(slope), std::cos(slope));
  const double dt        = 0.8 * system.critical_time_step();
  const auto   steps = [dt](const double time) { return static_cast<unsigned long>(time / dt); };
  advance(system, steps(0.3e-3), dt, []() {});
  const Frame  start = world.frames[0];
  const double from = world.time, mass = scene.bodies[0].mass;
  double       force = 0., sink = 0., samples = 0.;
  advance(system, steps(0.4e-3), dt, [&]() {
    force += system.contacts.families()[0]->records()[0].force * up;
    sink += (scene.bodies[0].initial.position - world.frames[0].position) * up;
    samples += 1.;
  });
  force /= samples;
  // with what it gains while it swings on the guide
  const Vector3 gained = (world.frames[0].velocity - start.velocity) / (world.time - from);
  ratio("acceleration down the slope", gained * down, g * std::sin(slope) - mu * force / mass, 3);
  ratio("force on the guide", force, mass * (g * std::cos(slope) + gained * up), 3);
  const double share = force / (k * (sink / samples + above));
  std::cout << "  gives way by its stiffness, and the link by less than half as much: "
            << (share > 0.66 && share < 1. ? "yes" : "no") << '\n';
  std::cout << "energy closes to 1e-3 of what is lost: "
            << (std::abs(world.ledger.imbalance()) < 1e-3 * world.ledger.lost() ? "yes" : "no")
            << '\n';
}

void come()
{
  for (const double above : {-0.5e-3, -1.5e-3})
    {
      scene::Scene scene               = link_on_guide(0., -0.022, above);
      scene.bodies[0].initial.velocity = vector(10., 0.);
      scene.guides[0].law.friction     = 0.;
      dynamics::System system(scene, false);
      const World     &world = system.world;
      const double     dt = 0.8 * system.critical_time_step(), energy = 50. * scene.bodies[0].mass;
      double           worst = 0., force = 0.;
      advance(system, static_cast<unsigned long>(3e-3 / dt), dt, [&]() {
        worst = std::max(worst, std::abs(world.ledger.imbalance()) / energy);
        force = std::max(force, system.contacts.families()[0]->records()[0].force.norm());
      });
      std::cout << std::setprecision(6) << "from " << 1e3 * above
                << " mm: it meets with more than 50 N: " << (force > 50. ? "yes" : "no")
                << ", is lifted: " << (world.frames[0].velocity[1] > 0.1 ? "yes" : "no")
                << ", energy closes to 1e-3: " << (worst < 1e-3 ? "yes" : "no") << '\n';
    }
}
} // namespace

int main()
{
  slide();
  come();
}
