// SPDX-License-Identifier: LGPL-2.1-or-later
// A wheel carried by an arm or a slide: with its spring it swings as a pendulum with the mass of
// the wheel on it does, turns freely, takes the forces on the wheel to its mount, and keeps its
// energy; critical time steps are those of two masses on one spring; a stop holds it; a damper that
// acts one way only takes its share of every other half swing, and alone stops it as exp(-c t/m).
#include "../support/scenes.h"

#include <chaindrive/contact/drum.h>
#include <chaindrive/forces/tensioner.h>

using namespace test;
using dealii::numbers::PI;

namespace
{
constexpr double wheel_mass = 0.3, carriage = 0.1, own = 2e-4, length = 0.08;

/// A wheel at the origin, which is carried by body 1: a slide along @p axis, or an arm about z.
scene::Scene carried_wheel(const bool slides, const drive::TensionerLaw &law)
{
  scene::Scene  scene = empty_scene();
  const Vector3 axis  = vector(0.6, 0.8, 0.);
  scene.bodies        = {
             body(scene::Motion::rigid,
           scene::Mount::revolute(),
           wheel_mass,
           vector(1., 1., 1e-4),
           Vector3()),
             body(scene::Motion::rigid,
           slides ? scene::Mount::prismatic(axis) :
                           scene::Mount::revolute(vector(0., 0., 1.), dealii::Point<3>(-length, 0., 0.)),
           slides ? wheel_mass + carriage : wheel_mass,
           vector(1., 1., own),
           Vector3())};
  scene.bodies[0].mount.carrier = 1;
  scene.tensioners.push_back({1, 0, 1, 0., law});
  return scene;
}

double inertia_of(const bool slides)
{
  return slides ? wheel_mass + carriage : own + wheel_mass * length * length;
}

drive::TensionerLaw spring(const double preload, const double stiffness)
{
  drive::TensionerLaw law;
  law.preload   = preload;
  law.stiffness = stiffness;
  return law;
}

/// The times and the places at which the tensioner of @p system stops, until there are @p n.
std::vector<std::pair<double, double>>
stops(dynamics::System &system, const scene::Scene &scene, const unsigned int n, const double dt)
{
  std::vector<std::pair<double, double>> found;
  double                                 before = 0.;
  while (found.size() < n && system.world.time < 10.)
    advance(system, 1, dt, [&]() {
      const TensionerState now = state_of(scene.tensioners[0], system.world);
      if (before * now.speed < 0.)
        found.emplace_back(system.world.time - dt * now.speed / (now.speed - before), now.travel);
      before = now.speed;
    });
  return found;
}
} // namespace

int main()
{
  for (const bool slides : {false, true})
    {
      const std::string name    = slides ? "slide" : "arm";
      const double      inertia = inertia_of(slides), k = slides ? 4e3 : 30.,
                   preload = slides ? 20. : 0.5;
      {
        scene::Scene scene                       = carried_wheel(slides, spring(preload, k));
        scene.bodies[0].initial.angular_velocity = vector(0., 0., 7.);
        dynamics::System system(scene, false);
        ratio(name + ": critical time step",
              system.critical_time_step(),
              2. * std::sqrt(inertia / k),
              6);
        const double dt   = 2e-3 * std::sqrt(inertia / k);
        const auto   turn = stops(system, scene, 1, dt);
        ratio("  half a period", turn[0].first, PI * std::sqrt(inertia / k), 5);
        ratio("  furthest", turn[0].second, 2. * preload / k, 5);
        const Vector3 way = system.world.frames[0].position;
        verdict("  the wheel is where its carrier is, and turns as it did",
                (way - system.world.frames[1].position).norm() == 0. &&
                    (slides ? std::abs(way.norm() - system.world.hubs[1].angle) < 1e-12 :
                              std::abs((way + vector(length, 0., 0.)).norm() - length) < 1e-12) &&
                    std::abs(system.world.hubs[0].speed - 7.) < 1e-12);
        verdict("  energy to 1e-5 of what the spring gave",
                std::abs(system.world.ledger.imbalance()) < 1e-5 * preload * preload / k);
      }
      {
        // gravity: the spring holds the wheel where m g of its lever is
        scene::Scene scene  = carried_wheel(slides, spring(0., k));
        scene.loads.gravity = 9.81;
        dynamics::System system(scene, false);
        const auto       turn = stops(system, scene, 1, 2e-3 * std::sqrt(inertia / k));
        double           low  = -0.2; // where the energy is that of the start again
        if (slides)
          low = -2. * (wheel_mass + carriage) * 9.81 * 0.8 / k;
        else
          for (unsigned int i = 0; i < 50; ++i)
            low = -2. / k * wheel_mass * 9.81 * length * std::sin(-low) / -low;
        ratio("  by its weight, furthest", turn[0].second, low, 5);
      }
      {
        // a lump flies against the wheel, along the way of its centre: both masses share a spring
        const double m = 0.05, stiff = 1e6;
        for (const bool planar : {false, true})
          {
            scene::Scene scene         = carried_wheel(slides, spring(0., 0.));
            scene.bodies[0].inertia[2] = 1e-2; // or it would be moved most easily by turning it
            const Vector3 along        = slides ? vector(0.6, 0.8, 0.) : vector(0., 1., 0.);
            scene.bodies.push_back(lump(m, -(20e-3 + 1e-4) * along, 2. * along));
            scene.surfaces.push_back(on_surface(std::make_shared<const contact::Drum>(0, 15e-3),
                                                {stiff, 0., 0., 0., 0.},
                                                {{2, dealii::Point<3>(), 5e-3, 0}}));
            scene.planar = planar;
            dynamics::System system(scene, false);
            const double     of_wheel = slides ? inertia : inertia / (length * length);
            if (!planar)
              ratio("  critical time step of a contact with the wheel",
                    system.critical_time_step(),
                    2. * std::sqrt(m * of_wheel / (m + of_wheel) / stiff),
                    6);
            advance(system, 4000, 1e-6, []() {});
            ratio(planar ? "  speed after an impact in the plane" : "  speed after an impact",
                  system.world.hubs[1].speed * (slides ? 1. : length),
                  2. * 2. * m / (m + of_wheel),
                  5);
          }
      }
      {
        // one way: over two half swings amplitudes fall by what the retracting one takes
        drive::TensionerLaw law = spring(preload, k);
        law.retracting_damping  = 2. * 0.1 * std::sqrt(k * inertia);
        scene::Scene     scene  = carried_wheel(slides, law);
        dynamics::System system(scene, false);
        const auto       turn = stops(system, scene, 3, 1e-3 * std::sqrt(inertia / k));
        const double     rest = preload / k, fall = std::exp(-PI * 0.1 / std::sqrt(1. - 0.01));
        ratio("  retraction is damped: first stop", turn[0].second, 2. * rest, 5);
        ratio("  second stop from rest", turn[1].second - rest, -rest * fall, 4);
        ratio("  third stop from rest", turn[2].second - rest, rest * fall, 4);
        verdict("  energy to 1e-5 of what the spring gave",
                std::abs(system.world.ledger.imbalance()) < 1e-5 * preload * preload / k);
      }
      {
        // without a spring: retracting it slows down as exp(-c t/m), advancing it does not
        drive::TensionerLaw law;
        law.retracting_damping = 40. * inertia;
        for (const int sign : {-1, 1})
          {
            scene::Scene scene                       = carried_wheel(slides, law);
            scene.bodies[1].initial.angular_velocity = vector(0., 0., sign * 1.5);
            scene.bodies[1].initial.velocity         = sign * 1.5 * vector(0.6, 0.8, 0.);
            dynamics::System system(scene, false);
            advance(system, 50000, 1e-6, []() {});
            ratio(sign < 0 ? "  speed while it retracts" : "  speed while it advances",
                  system.world.hubs[1].speed,
                  sign * 1.5 * (sign < 0 ? std::exp(-40. * 0.05) : 1.),
                  4);
          }
      }
      {
        // a stop: spring and preload press it there
        drive::TensionerLaw law = spring(preload, k);
        law.most                = 0.1 * preload / k;
        law.stop_stiffness      = 1e4 * k;
        law.stop_damping        = 0.4 * std::sqrt(law.stop_stiffness * inertia);
        scene::Scene     scene  = carried_wheel(slides, law);
        dynamics::System system(scene, false);
        advance(system,
                static_cast<unsigned long>(40. * std::sqrt(inertia / k) /
                                           (0.5 * system.critical_time_step())),
                0.5 * system.critical_time_step(),
                []() {});
        const TensionerState now = state_of(scene.tensioners[0], system.world);
        ratio("  beyond its stop by",
              now.travel - law.most,
              (preload - k * now.travel) / law.stop_stiffness,
              3);
      }
    }
}
