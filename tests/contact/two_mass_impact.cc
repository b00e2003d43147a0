// SPDX-License-Identifier: LGPL-2.1-or-later
// Two masses collide on an undamped penalty spring: peak force v sqrt(k m1 m2/(m1 + m2)), duration
// half a period, velocities exchanged as in an elastic collision. The error of the peak falls with
// the square of the step; it is averaged (rms) over the moment of the step at which the masses
// meet. With a dashpot, whose force begins with a jump, so does the imbalance of energy.
#include "../support/scenes.h"

using namespace test;

namespace
{
struct Outcome
{
  double peak, rebound_error, restitution, momentum_error;
  double imbalance; ///< of energy, of what the masses had
};

Outcome collide(const double dt, const double phase, const double damping)
{
  const double m1 = 0.01, m2 = 0.03, k = 2e8, v = 1.5, r = 1e-3;
  scene::Scene scene = empty_scene();
  // the first mass flies towards -x onto the face x = 0 of the second
  scene.bodies = {lump(m1, vector(r + (2. + phase) * v * dt, 0.), vector(-v, 0.)),
                  lump(m2, Vector3())};
  scene.surfaces.push_back(on_surface(
      plane(1, vector(1., 0.)), {k, damping, 0., 0., 0.}, {{0, dealii::Point<3>(), r, 0}}));
  dynamics::System system(scene, false);
  const double     m = m1 * m2 / (m1 + m2);
  // Largest force between the steps: the parabola through the largest sample and its neighbours.
  double       before = 0., now = 0., peak = 0.;
  const double energy      = 0.5 * m1 * v * v;
  const double half_period = dealii::numbers::PI * std::sqrt(m / k);
  advance(system, static_cast<unsigned long>(1.5 * half_period / dt) + 5, dt, [&]() {
    const double next = system.contacts.families()[0]->records()[0].force[0];
    if (now >= before && now > next && now > 0.)
      peak = std::max(peak,
                      now + (next - before) * (next - before) / (8. * (2. * now - before - next)));
    before = now;
    now    = next;
  });
  const double u1 = system.world.frames[0].velocity[0], u2 = system.world.frames[1].velocity[0];
  Outcome      outcome;
  outcome.peak           = peak / (v * std::sqrt(k * m)) - 1.;
  outcome.rebound_error  = u1 / (-v * (m1 - m2) / (m1 + m2)) - 1.;
  outcome.restitution    = (u1 - u2) / v;
  outcome.momentum_error = (m1 * u1 + m2 * u2) / (-m1 * v) - 1.;
  outcome.imbalance =
      (0.5 * m1 * u1 * u1 + 0.5 * m2 * u2 * u2 + system.world.ledger.contact_damping) / energy - 1.;
  return outcome;
}
} // namespace

int main()
{
  double before = 0.;
  for (const double dt : {1e-6, 0.5e-6, 0.25e-6, 0.125e-6})
    {
      double             sum = 0., worst_restitution = 1., worst_momentum = 0.;
      const unsigned int n = 32;
      for (unsigned int i = 0; i < n; ++i)
        {
          const Outcome outcome = collide(dt, (i + 0.5) / n, 0.);
          sum += outcome.peak * outcome.peak;
          worst_restitution = std::min(worst_restitution, outcome.restitution);
          worst_momentum    = std::max(worst_momentum, std::abs(outcome.momentum_error));
        }
      const double rms = std::sqrt(sum / n);
      std::cout << "step " << dt * 1e6 << " us: rms error of the peak " << std::setprecision(3)
                << rms * 1e3 << " per mille";
      if (before > 0.)
        std::cout << ", order " << std::fixed << std::setprecision(2) << std::log2(before / rms)
                  << std::defaultfloat;
      std::cout << '\n';
      verdict("  restitution at least 0.99", worst_restitution >= 0.99);
      verdict("  momentum kept to 1e-12", worst_momentum < 1e-12);
      before = rms;
    }
  // damped: restitution of the linear spring and dashpot whose force never pulls
  const double  m = 0.01 * 0.03 / 0.04, k = 2e8, xi = 0.1;
  const Outcome damped = collide(0.02e-6, 0.5, 2. * xi * std::sqrt(k * m));
  const double  root   = std::sqrt(1. - xi * xi);
  // contact ends when k d + c d' = 0 (Schwager and Poeschel 2007)
  const double expected = std::exp(
      -xi / root * (dealii::numbers::PI - std::atan(2. * xi * root / (1. - 2. * xi * xi))));
  ratio("restitution with damping ratio 0.1", damped.restitution, expected, 4);
  before = 0.;
  for (const double dt : {1e-6, 0.5e-6, 0.25e-6, 0.125e-6})
    {
      double             sum = 0.;
      const unsigned int n   = 32;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double imbalance = collide(dt, (i + 0.5) / n, 2. * xi * std::sqrt(k * m)).imbalance;
          sum += imbalance * imbalance / n;
        }
      const double rms = std::sqrt(sum);
      verdict("  imbalance of energy below 4e-3 at 1 us, and by the square of the step",
              rms < 4e-3 * dt * dt / 1e-12);
      if (before > 0.)
        std::cout << "  order " << std::fixed << std::setprecision(1) << std::log2(before / rms)
                  << std::defaultfloat << '\n';
      before = rms;
    }
}
