// SPDX-License-Identifier: LGPL-2.1-or-later
// Rollers that become ovals: a thin ring has the stiffness, mass and frequency of the textbook; a
// roller that meets a bush in its bore or a tooth has the peak force of the system of two masses
// and two springs, whatever the direction, and rings at its frequency afterwards; pressed from both
// sides of its wall it stays round; and whatever bush, roller and teeth do, energy stays.
#include "../support/planar_roller.h"

#include <chaindrive/bodies/planar_bodies.h>
#include <chaindrive/contact/planar_contact.h>
#include <chaindrive/drive/roller_ring.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using namespace test;
using namespace test::planar_roller;
using dealii::numbers::PI;

namespace
{
constexpr double        roller_mass = planar_roller::mass;
const Material          steel;
const drive::RollerRing ring = drive::oval_of_ring(bore_radius, radius, 7e-3, steel);

/// The frequencies and the peak force of a mass that flies with the speed v [m/s] onto a ring,
/// whose mode has the share @p share of the contact.
struct Impact
{
  explicit Impact(const double share, const double v)
  {
    // of x and w: m x'' = -N, M w'' = -k2 w + s N, N = k (x - s w), in units of root mass
    const double a = k / roller_mass, b = (ring.stiffness + share * share * k) / ring.mass,
                 c      = -share * k / std::sqrt(roller_mass * ring.mass);
    const double middle = 0.5 * (a + b), half = std::hypot(0.5 * (a - b), c);
    for (unsigned int i = 0; i < 2; ++i)
      {
        const double square = middle + (i == 0 ? -half : half);
        const double x = c, y = square - a, norm = std::hypot(x, y);
        frequency[i] = std::sqrt(square);
        // x(t) = v sum (x_i / norm)^2 sin(w t) / w; N likewise
        const double in_x = x / norm / std::sqrt(roller_mass),
                     in_w = y / norm / std::sqrt(ring.mass);
        force[i]          = k * (in_x - share * in_w) * in_x * roller_mass * v / frequency[i];
      }
    for (double t = 0.; t < PI / frequency[0]; t += 1e-9)
      {
        const double n =
            force[0] * std::sin(frequency[0] * t) + force[1] * std::sin(frequency[1] * t);
        if (n < 0.)
          break;
        peak = std::max(peak, n);
      }
  }

  double frequency[2], force[2], peak = 0.;
};

/// Those of planar_roller.h with a roller that becomes oval.
scene::Scene
roller_and_bush(const double bush_mass, const Vector3 &roller_at, const Vector3 &bush_at)
{
  scene::Scene scene = planar_roller::roller_and_bush(bush_mass, roller_at, bush_at);
  scene.oval         = ring;
  return scene;
}

/// The largest force of the first touch and, of what follows, the mean of the oval's half periods,
/// s.
void collide(scene::Scene scene, const double dt, double &peak, double &half_period)
{
  dynamics::System    system(scene, false);
  const PlanarBodies &planar = *system.world.planar;
  const auto         &family = *system.contacts.families()[0];
  const unsigned int  slot   = planar.slot_of(0);
  peak                       = 0.;
  bool touches               = false,
       parted                = false; // the oval may fling the roller back at once: the first touch
  advance(system, static_cast<unsigned long>(30e-6 / dt), dt, [&]() {
    double force = 0.;
    for (const contact::Record &record : family.records())
      force = std::max(force, record.force.norm());
    parted  = parted || (touches && force == 0.);
    touches = touches || force > 0.;
    if (!parted)
      peak = std::max(peak, force);
  });
  std::vector<double> zeros;
  double              before = 0.;
  const unsigned int  which =
      std::abs(planar.oval_of(slot)[0]) + 1e-12 > std::abs(planar.oval_of(slot)[1]) ? 0 : 1;
  advance(system, static_cast<unsigned long>(45e-6 / dt), dt, [&]() {
    const double now = planar.oval_of(slot)[which];
    if (before * now < 0.)
      zeros.push_back(system.world.time - dt * now / (now - before));
    before = now;
  });
  half_period = zeros.size() < 2 ? 0. : (zeros.back() - zeros.front()) / (zeros.size() - 1);
}

/// The largest imbalance of a bush that rattles in a roller between teeth, over its energy.
double rattle(const double dt)
{
  const drive::ToothForm teeth  = form();
  const double           bottom = 0.5 * teeth.root_diameter + radius;
  scene::Scene           scene =
      roller_and_bush(5e-3, vector(bottom + 30e-6, 5e-6), vector(bottom + 70e-6, 20e-6));
  add_teeth(scene, teeth);
  return thrown_together(scene, dt);
}
} // namespace

int main()
{
  const drive::RollerRing thin    = drive::oval_of_ring(0.0995, 0.1005, 0.02, steel);
  const double            inertia = 0.02 * 1e-9 / 12.; // of the wall of 1 mm
  ratio(
      "stiffness of a thin ring", thin.stiffness, 9. * PI * steel.plane_modulus() * inertia / 1e-3);
  ratio("mass of a thin ring", thin.mass, 1.25 * PI * steel.density * 0.02 * 1e-3 * 0.1);
  // omega^2 = E' I / (rho A R^4) n^2 (n^2 - 1)^2 / (n^2 + 1) (Blevins 1979, ch. 9)
  ratio("square of its frequency",
        thin.stiffness / thin.mass,
        7.2 * steel.plane_modulus() * inertia / (steel.density * 0.02 * 1e-3 * 1e-4));
  ratio("its bore follows the outside", thin.bore, 1., 3);

  const double own_half_period = PI / std::sqrt(ring.stiffness / ring.mass);
  double       peak = 0., half_period = 0.;
  for (const double angle : {0., 0.4, 2.5, -1.1})
    {
      const Vector3 along              = vector(std::cos(angle), std::sin(angle));
      scene::Scene  scene              = roller_and_bush(1e6, Vector3(), 59.9e-6 * along);
      scene.bodies[0].initial.velocity = -1.5 * along;
      collide(scene, 1e-8, peak, half_period);
      ratio("peak of a roller that meets a bush", peak, Impact(ring.bore, 1.5).peak);
      ratio("half a period of its oval afterwards", half_period, own_half_period);
    }
  const drive::ToothForm teeth  = form();
  const double           bottom = 0.5 * teeth.root_diameter + radius;
  for (const int width : {1, 2, 4, 8})
    if (has_simd_width(width))
      {
        setenv("CHAINDRIVE_SIMD_WIDTH", std::to_string(width).c_str(), 1);
        scene::Scene scene = roller_and_bush(1e6, vector(bottom + 1e-7, 0.), vector(1., 0.));
        scene.bores        = {};
        scene.bodies[0].initial.velocity = vector(-1.5, 0.);
        add_teeth(scene, teeth);
        collide(scene, 1e-8, peak, half_period);
        verdict("peak of a roller that meets a tooth to 1e-4",
                std::abs(peak / Impact(1., 1.5).peak - 1.) < 1e-4);
        verdict("half a period of its oval afterwards to 1e-4",
                std::abs(half_period / own_half_period - 1.) < 1e-4);
        unsetenv("CHAINDRIVE_SIMD_WIDTH");
      }

  // tooth and bush press the wall from both sides: nothing bends but by what the bore follows less
  scene::Scene pressed =
      roller_and_bush(1e6, vector(bottom - 1e-6, 0.), vector(bottom - 1e-6 - 61e-6, 0.));
  add_teeth(pressed, teeth);
  dynamics::System    between(pressed, false);
  const PlanarBodies &planar = *between.world.planar;
  const double        bends  = between.world.planar->forces_on_ovals()[planar.slot_of(0)];
  ratio("what bends a wall between two forces of 200 N", bends, 200. * (ring.bore - 1.), 2);

  const double coarse = rattle(4e-8), fine = rattle(2e-8);
  verdict("a bush rattles in a roller between teeth: energy to 1e-4", fine < 1e-4);
  verdict("and the error falls with the square of the step", fine < coarse / 3.);
}
