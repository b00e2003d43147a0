// SPDX-License-Identifier: LGPL-2.1-or-later
// Rollers that become ovals on contacts that are stiffer the more they bear: a roller that meets a
// bush or a tooth, at any place of the seat, has the peak force and leaves with the oval of two
// masses on the spring of the ring and that of the curve, integrated by themselves; bush, roller
// and teeth keep their energy while they rattle; and the critical time step is a bound.
#include "../support/planar_roller.h"

#include <chaindrive/bodies/planar_bodies.h>
#include <chaindrive/contact/planar_contact.h>
#include <chaindrive/drive/roller_ring.h>
#include <chaindrive/drive/stiffness_fit.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

using namespace test;
using namespace test::planar_roller;
using dealii::numbers::PI;

namespace
{
constexpr double        roller_mass = planar_roller::mass, speed = 1.5; // m/s
const Material          steel;
const drive::RollerRing ring = drive::oval_of_ring(bore_radius, radius, 7e-3, steel);

const drive::StiffnessCurve on_bush = {{0.4 * k, 0., 0.}, {1.6 * k, 0., 0.}, 3e-6};

/// Half as stiff at the end of the seat, and stiffer where it bears more.
drive::StiffnessCurve on_teeth(const drive::ToothForm &form)
{
  const double end = 1. - std::cos(form.seat_half_angle);
  return {{k, -0.5 * k / end, 0.},
          {1.8 * k, -0.9 * k / end, 0.},
          2e-6,
          0.5 * form.root_diameter,
          form.seat_radius,
          end};
}

struct Impact
{
  double peak = 0.; ///< N
  double oval = 0.; ///< stretch and swing of the oval when they part, as an amplitude, m
};

/// A mass that flies onto the @p share of a ring in a contact of this force: Runge and Kutta's
/// method, of fourth order, until they part.
template <typename Force>
Impact of_two_masses(const double share, const Force &force)
{
  using State        = std::array<double, 4>; // approach of the mass, oval, and their rates
  const auto pressed = [&](const State &y) { return force(std::max(0., y[0] - share * y[1])); };
  const auto rate    = [&](const State &y) -> State {
    const double n = pressed(y);
    return {{y[2], y[3], -n / roller_mass, (share * n - ring.stiffness * y[1]) / ring.mass}};
  };
  const auto moved = [](const State &y, const State &by, const double h) {
    State result = y;
    for (unsigned int i = 0; i < 4; ++i)
      result[i] += h * by[i];
    return result;
  };
  const double dt = 2e-9;
  State        y  = {{0., 0., speed, 0.}};
  Impact       impact;
  do
    {
      const State a = rate(y), b = rate(moved(y, a, 0.5 * dt)), c = rate(moved(y, b, 0.5 * dt)),
                  d = rate(moved(y, c, dt));
      for (unsigned int i = 0; i < 4; ++i)
        y[i] += dt / 6. * (a[i] + 2. * b[i] + 2. * c[i] + d[i]);
      impact.peak = std::max(impact.peak, pressed(y));
    }
  while (y[0] > share * y[1]);
  impact.oval = std::hypot(y[1], y[3] / std::sqrt(ring.stiffness / ring.mass));
  return impact;
}

/// The same of a roller in a run, whose only contact is the first one.
Impact collide(const scene::Scene &scene)
{
  dynamics::System    system(scene, false);
  const PlanarBodies &planar = *system.world.planar;
  const auto         &family = *system.contacts.families()[0];
  const unsigned int  slot   = planar.slot_of(0);
  const double        dt     = 2e-9;
  Impact              impact;
  bool                touches = false, parted = false;
  auto                before = planar.oval_of(slot);
  advance(system, static_cast<unsigned long>(40e-6 / dt), dt, [&]() {
    double force = 0.;
    for (const contact::Record &record : family.records())
      force = std::max(force, record.force.norm());
    if (!parted && touches && force == 0.)
      {
        // how far the oval is, and its rate over its frequency
        const auto   now   = planar.oval_of(slot);
        const double omega = std::sqrt(ring.stiffness / ring.mass);
        impact.oval        = std::hypot(now.norm(), (now - before).norm() / (dt * omega));
        parted             = true;
      }
    before  = planar.oval_of(slot);
    touches = touches || force > 0.;
    if (!parted)
      impact.peak = std::max(impact.peak, force);
  });
  return impact;
}

void compare(const std::string &what, const Impact &found, const Impact &expected)
{
  verdict(what + ": peak to 2e-4", std::abs(found.peak / expected.peak - 1.) < 2e-4);
  verdict("  and the oval that is left to 2e-3",
          expected.oval > 1e-7 && std::abs(found.oval / expected.oval - 1.) < 2e-3);
}

scene::Scene with_bush(const double bush_mass, const Vector3 &roller_at, const Vector3 &bush_at)
{
  scene::Scene scene   = roller_and_bush(bush_mass, roller_at, bush_at);
  scene.oval           = ring;
  scene.bores[0].curve = on_bush;
  return scene;
}

/// Bush, roller and teeth that turn: the largest imbalance over their energy.
double rattle(const double dt)
{
  const drive::ToothForm teeth  = form();
  const double           bottom = 0.5 * teeth.root_diameter + radius;
  scene::Scene scene = with_bush(5e-3, vector(bottom + 30e-6, 5e-6), vector(bottom + 70e-6, 20e-6));
  add_teeth(scene, teeth);
  scene.teeth[0].curve = on_teeth(teeth);
  return thrown_together(scene, dt);
}
} // namespace

int main()
{
  for (const int width : {1, 2, 4, 8})
    if (has_simd_width(width))
      {
        setenv("CHAINDRIVE_SIMD_WIDTH", std::to_string(width).c_str(), 1);
        const double  angle              = 0.7 * width;
        const Vector3 along              = vector(std::cos(angle), std::sin(angle));
        scene::Scene  scene              = with_bush(1e6, Vector3(), 59.9e-6 * along);
        scene.bodies[0].initial.velocity = -speed * along;
        compare(
            "a roller meets a bush", collide(scene), of_two_masses(ring.bore, [](const double d) {
              return drive::force_of(on_bush, 0., d);
            }));
        unsetenv("CHAINDRIVE_SIMD_WIDTH");
      }
  const drive::ToothForm teeth = form();
  const double           room  = teeth.seat_radius - radius;
  for (const double angle : {0., 0.5, -0.8})
    {
      // along the normal of the seat: only what is softer higher up pushes sideways, which takes a
      // ten-thousandth of the peak
      const double  centre  = 0.5 * teeth.root_diameter + teeth.seat_radius;
      const Vector3 outward = vector(-std::cos(angle), std::sin(angle));
      scene::Scene  scene =
          with_bush(1e6, vector(centre, 0.) + (room - 1e-7) * outward, vector(1., 0.));
      scene.bores                      = {};
      scene.bodies[0].initial.velocity = speed * outward;
      add_teeth(scene, teeth);
      scene.teeth[0].curve = on_teeth(teeth);
      const double place   = 1. - std::cos(angle);
      compare("a roller meets a seat at " + std::to_string(angle).substr(0, 4) + " rad",
              collide(scene),
              of_two_masses(1., [&](const double d) {
                return drive::force_of(*scene.teeth[0].curve, place, d);
              }));
    }
  const double coarse = rattle(4e-8), fine = rattle(2e-8);
  verdict("a bush rattles in a roller between teeth: energy to 2e-4", fine < 2e-4);
  verdict("and the error falls with the square of the step", fine < coarse / 3.);

  // a mass on the stiffest tangent, and the ring on it: the larger frequency of the two is below
  // what the limit allows for, and not far
  scene::Scene scene = with_bush(1e6, Vector3(), 62e-6 * vector(1., 0.));
  const double limit = dynamics::System(scene, false).critical_time_step(),
               stiff = drive::stiffest(on_bush), a = stiff / roller_mass,
               b     = (ring.stiffness + ring.bore * ring.bore * stiff) / ring.mass,
               c     = ring.bore * stiff / std::sqrt(roller_mass * ring.mass),
               omega = std::sqrt(0.5 * (a + b) + std::hypot(0.5 * (a - b), c));
  verdict("the critical time step is at most that of the two masses, and at least 0.7 of it",
          limit < 2.0001 / omega && limit > 0.7 * 2. / omega);
}
