// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts that get stiffer the more they bear, and teeth that are softer higher up: a fit finds
// the curve that forces were made of, and with tangents the tangent of a power law at the load; a
// body that meets a bush with the force k d^2 has the peak and the duration of the closed form, and
// beyond the depth up to which stiffness grows the peak that its energy makes; a roller anywhere on
// a seat bears what the curve says there; whatever bush, roller and teeth do, energy stays, also on
// the way around, but not on chords that are softer higher up; and the critical time step is that
// of the largest tangent stiffness.
#include "../support/planar_roller.h"

#include <chaindrive/contact/planar_contact.h>
#include <chaindrive/drive/stiffness_fit.h>
#include <chaindrive/utilities/simd.h>
#include <chaindrive/utilities/text.h>

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
constexpr double roller_mass = planar_roller::mass;

/// One curve for all places.
drive::StiffnessCurve joint(const double first, const double last, const double depth)
{
  return {{first, 0., 0.}, {last, 0., 0.}, depth};
}

/// Those of planar_roller.h with this @p curve.
scene::Scene roller_and_bush(const double                 bush_mass,
                             const Vector3               &roller_at,
                             const Vector3               &bush_at,
                             const drive::StiffnessCurve &curve)
{
  scene::Scene scene   = planar_roller::roller_and_bush(bush_mass, roller_at, bush_at);
  scene.bores[0].curve = curve;
  return scene;
}

/// Half as stiff at the end of the seat, and stiffer where it bears more.
drive::StiffnessCurve teeth_of(const drive::ToothForm &form)
{
  const double end = 1. - std::cos(form.seat_half_angle);
  return {{k, -0.7 * k / end, 0.2 * k / end / end},
          {1.5 * k, -1.2 * k / end, 0.5 * k / end / end},
          2e-6,
          0.5 * form.root_diameter,
          form.seat_radius,
          end};
}

void add_teeth(scene::Scene &scene, const drive::ToothForm &form)
{
  planar_roller::add_teeth(scene, form);
  scene.teeth[0].curve = teeth_of(form);
}

/// As add_teeth(), of chords.
void add_chords(scene::Scene &scene, const drive::ToothForm &form)
{
  planar_roller::add_teeth(scene, form.faceted(48));
  scene.teeth[0].curve = teeth_of(form);
}

/// The same, everywhere as at the bottom of a gap.
void add_equal_chords(scene::Scene &scene, const drive::ToothForm &form)
{
  add_chords(scene, form);
  scene.teeth[0].curve->end = 0.;
}

/// How the energy of a contact that is @p d deep at @p angle on the seat grows with the angle
/// [J/rad]: the slope of what its force does, by Simpson's rule.
double slope_of_energy(const drive::StiffnessCurve &curve, const double angle, const double d)
{
  const auto energy = [&](const double at) {
    constexpr int n   = 200;
    double        sum = 0.;
    for (int i = 0; i <= n; ++i)
      sum += (i == 0 || i == n ? 1. :
              i % 2            ? 4. :
                                 2.) *
             drive::force_of(curve, 1. - std::cos(at), d * i / n);
    return sum * d / n / 3.;
  };
  return (energy(angle + 1e-5) - energy(angle - 1e-5)) / 2e-5;
}

/// The largest force and the duration [s] of the impact of a roller that flies onto a bush which
/// hardly moves.
void collide(const Vector3               &along,
             const double                 speed,
             const drive::StiffnessCurve &curve,
             double                      &peak,
             double                      &duration)
{
  const double dt                  = 1e-9;
  scene::Scene scene               = roller_and_bush(1e6, Vector3(), 59.999e-6 * along, curve);
  scene.bodies[0].initial.velocity = -speed * along;
  dynamics::System system(scene, false);
  const auto      &family = *system.contacts.families()[0];
  double           begin = -1., end = -1., before = -1.;
  peak = 0.;
  advance(system, 40000, dt, [&]() {
    const contact::Record &record = family.records()[0];
    const double           gap = record.gap, now = system.world.time;
    peak = std::max(peak, record.force.norm());
    if (gap < 0. && begin < 0.) // the first touch is not on a step
      begin = now + gap / speed;
    if (gap >= 0. && before < 0. && begin >= 0. && end < 0.)
      end = now - gap / speed;
    before = gap;
  });
  duration = end - begin;
}

/// What a contact stores at the approach @p d, J: first d^2 / 2 and what the growth adds.
double energy(const double first, const double last, const double depth, const double d)
{
  const double beyond = std::max(0., d - depth);
  return 0.5 * first * d * d +
         (last - first) / (6. * depth) * (d * d * d - beyond * beyond * beyond);
}

/// The largest imbalance of a bush that rattles in a roller between teeth, over its energy.
double rattle(const double dt)
{
  const drive::ToothForm teeth  = form();
  const double           bottom = 0.5 * teeth.root_diameter + radius;
  scene::Scene           scene  = roller_and_bush(5e-3,
                                       vector(bottom + 30e-6, 5e-6),
                                       vector(bottom + 70e-6, 20e-6),
                                       joint(0.5 * k, 1.5 * k, 3e-6));
  add_teeth(scene, teeth);
  return thrown_together(scene, dt);
}

/// A roller that slides up and down a seat on which it is pressed by twenty thousand times its
/// weight: the largest imbalance over the energy of its swing. Of the seat @p add adds the teeth.
double slide(const double dt, void (*add)(scene::Scene &, const drive::ToothForm &) = add_teeth)
{
  const drive::ToothForm teeth  = form();
  const double           bottom = 0.5 * teeth.root_diameter + radius;
  scene::Scene           scene  = empty_scene();
  scene.prestress               = 1e9;
  scene.planar                  = true;
  scene.loads.gravity           = 2e5;
  const double room             = teeth.seat_radius - radius;
  // 0.9 rad from the bottom, which looks up
  const Vector3 at = vector(-room * std::sin(0.9), bottom + room * (1. - std::cos(0.9)) - 2e-6);
  scene.bodies     = {
          body(scene::Motion::rigid, scene::Mount::free(), roller_mass, vector(1e-8, 1e-8, 2e-8), at)};
  add(scene, teeth);
  scene.bodies[1].initial.rotation =
      to_matrix(Quaternion{std::cos(0.25 * PI), 0., 0., std::sin(0.25 * PI)});
  dynamics::System system(scene, false);
  double           worst = 0., least = at[0], most = at[0];
  advance(system, static_cast<unsigned long>(400e-6 / dt), dt, [&]() {
    worst = std::max(worst, std::abs(system.world.ledger.imbalance()));
    system.world.planar->publish(system.world);
    least = std::min(least, system.world.frames[0].position[0]);
    most  = std::max(most, system.world.frames[0].position[0]);
  });
  if (dt < 3e-8)
    verdict("it slides from one side of the seat to the other",
            most > 0.5 * room && least < -0.5 * room);
  return worst / (roller_mass * scene.loads.gravity * room * (1. - std::cos(0.9)));
}

/// By how much a push of 1 nm grows of a roller that is pressed far into a bottom of a gap, when
/// steps are @p share of the limit.
double growth(const double share, double &limit)
{
  const drive::ToothForm teeth  = form();
  const double           bottom = 0.5 * teeth.root_diameter + radius, d = 10e-6;
  const auto             curve = teeth_of(teeth);
  scene::Scene           scene = empty_scene();
  scene.prestress              = 1e9;
  scene.planar                 = true;
  scene.loads.gravity          = drive::force_of(curve, 0., d) / roller_mass;
  scene.bodies                 = {body(scene::Motion::rigid,
                       scene::Mount::free(),
                       roller_mass,
                       vector(1e-8, 1e-8, 2e-8),
                       vector(0., bottom - d + 1e-9))};
  add_teeth(scene, teeth);
  scene.bodies[1].initial.rotation =
      to_matrix(Quaternion{std::cos(0.25 * PI), 0., 0., std::sin(0.25 * PI)});
  dynamics::System system(scene, false);
  const auto      &family = *system.contacts.families()[0];
  limit                   = system.critical_time_step();
  double worst            = 0.;
  advance(system, 400, share * limit, [&]() {
    worst = std::max(worst, std::abs(family.records()[0].gap + d) / 1e-9);
  });
  return worst;
}
} // namespace

int main()
{
  drive::Approaches made;
  for (const double d : {0.3e-6, 1e-6, 3e-6, 8e-6})
    {
      made.approach.push_back(d);
      made.force.push_back(0.8 * k * d + 0.5 * k / (2. * 8e-6) * d * d);
    }
  const drive::StiffnessCurve fitted = drive::fit_stiffness({made});
  ratio("first stiffness of a fit", fitted.first[0], 0.8 * k);
  ratio("last", fitted.last[0], 1.3 * k);
  std::vector<drive::Approaches> places;
  for (const double place : {0., 0.2, 0.5})
    {
      drive::Approaches there = made;
      there.place             = place;
      for (double &force : there.force)
        force *= 1. - 1.1 * place + 0.4 * place * place;
      places.push_back(there);
    }
  const drive::StiffnessCurve of_places = drive::fit_stiffness(places);
  ratio("force between places",
        drive::force_of(of_places, 0.37, 5e-6),
        (1. - 1.1 * 0.37 + 0.4 * 0.37 * 0.37) * drive::force_of(fitted, 0., 5e-6));
  ratio("of two places",
        drive::force_of(drive::fit_stiffness({places[0], places[2]}), 0.25, 5e-6),
        0.775 * drive::force_of(fitted, 0., 5e-6));
  ratio("the largest stiffness of all", drive::stiffest(of_places), 1.3 * k);
  // of a power law, whose tangent is the power times the secant, at the third of four loads
  drive::Approaches law;
  for (const double force : {0.1, 0.3, 1., 3.})
    {
      law.force.push_back(1e4 * force);
      law.approach.push_back(30e-6 * std::pow(force, 1. / 1.15));
    }
  const auto tangent = [&](const bool with_tangents) {
    const drive::StiffnessCurve curve = drive::fit_stiffness({law}, with_tangents);
    return (drive::force_of(curve, 0., 30.01e-6) - drive::force_of(curve, 0., 29.99e-6)) / 0.02e-6 /
           (1.15 * 1e4 / 30e-6);
  };
  const auto error_of_forces = [&](const bool with_tangents) {
    const drive::StiffnessCurve curve = drive::fit_stiffness({law}, with_tangents);
    double                      worst = 0.;
    for (std::size_t i = 0; i < law.force.size(); ++i)
      worst = std::max(worst,
                       std::abs(drive::force_of(curve, 0., law.approach[i]) / law.force[i] - 1.));
    return worst;
  };
  verdict("tangent at the load of a fit with tangents within 2.5 %, of forces alone not within 5",
          std::abs(tangent(true) - 1.) < 0.025 && std::abs(tangent(false) - 1.) > 0.05);
  verdict("its forces within 4 %", error_of_forces(true) < 0.04);
  double off = 0.;
  for (const double d : {1e-12, 1e-6, 5e-6, 0.999 * fitted.depth, 1.001 * fitted.depth, 1e-4})
    for (const double place : {0., 0.37, 0.6})
      off = std::max(
          off,
          std::abs(drive::approach_of(of_places, place, drive::force_of(of_places, place, d)) / d -
                   1.));
  std::cout << "approach of the force of an approach, off by: " << (off < 1e-12 ? 0. : off)
            << std::endl;

  // m v^2 / 2 = c d^3 / 3; the way takes 2 d / v times the integral of 1 / sqrt(1 - x^3) from 0 to
  // 1
  const double speed = 1.2, c = 5e13, deepest = std::cbrt(1.5 * roller_mass * speed * speed / c),
               integral = std::sqrt(PI) * std::tgamma(4. / 3.) / std::tgamma(5. / 6.);
  double peak = 0., duration = 0.;
  for (const int width : {1, 2, 4, 8})
    if (has_simd_width(width))
      {
        setenv("CHAINDRIVE_SIMD_WIDTH", std::to_string(width).c_str(), 1);
        const double angle = 0.7 * width;
        collide(vector(std::cos(angle), std::sin(angle)),
                speed,
                joint(0., 2. * c * 20e-6, 20e-6),
                peak,
                duration);
        verdict("peak of an impact on c d^2 to 1e-4",
                std::abs(peak / (c * deepest * deepest) - 1.) < 1e-4);
        verdict("its duration to 1e-4",
                std::abs(duration / (2. * deepest / speed * integral) - 1.) < 1e-4);
        unsetenv("CHAINDRIVE_SIMD_WIDTH");
      }
  collide(vector(1., 0.), speed, joint(k, 2. * k, 1e-6), peak, duration);
  double low = 0., high = 20e-6;
  for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (low + high);
      (energy(k, 2. * k, 1e-6, middle) < 0.5 * roller_mass * speed * speed ? low : high) = middle;
    }
  ratio("peak of an impact beyond the depth", peak, 2. * k * low - 0.5 * k * 1e-6);

  const drive::ToothForm teeth = form();
  const double           room = teeth.seat_radius - radius, d = 1.4e-6;
  for (const double angle : {0., 0.3, -0.3, 0.8, -0.8})
    {
      // the seat's centre is so far from the axis
      const double centre = 0.5 * teeth.root_diameter + teeth.seat_radius;
      scene::Scene scene  = roller_and_bush(
          1e6,
          vector(centre - (room + d) * std::cos(angle), (room + d) * std::sin(angle)),
          vector(1., 0.),
          joint(k, k, 1e-6));
      scene.bores = {};
      add_teeth(scene, teeth);
      dynamics::System system(scene, false);
      const Vector3    force   = system.contacts.families()[0]->records()[0].force;
      const Vector3    outward = vector(-std::cos(angle), std::sin(angle)),
                    along      = vector(std::sin(angle), std::cos(angle));
      const std::string place  = " on a seat at " + to_text(angle) + " rad";
      ratio("force" + place,
            std::abs(force * outward),
            drive::force_of(teeth_of(teeth), 1. - std::cos(angle), d));
      if (angle != 0.)
        ratio("push" + place + " towards its softer end",
              force * along,
              -slope_of_energy(teeth_of(teeth), angle, d) / (room + d));
    }

  const double coarse = rattle(4e-8), fine = rattle(2e-8);
  verdict("a bush rattles in a roller between teeth: energy to 2e-4", fine < 2e-4);
  verdict("and the error falls with the square of the step", fine < coarse / 3.);
  const double coarser = slide(4e-8), finer = slide(2e-8);
  verdict("a roller slides on a seat: energy to 2e-6", finer < 2e-6);
  verdict("and the error falls with the square of the step", finer < coarser / 3.);
  // a contact jumps at the corners of chords
  const double chords = slide(2e-8, add_equal_chords);
  verdict("on chords, everywhere as stiff: energy to 2e-3", chords < 2e-3);
  verdict("twenty times as wrong where they are softer higher up",
          slide(2e-8, add_chords) > 20. * chords);

  double limit = 0.;
  verdict("bounded at 0.98 of the limit", growth(0.98, limit) < 20.);
  verdict("not at 1.02", growth(1.02, limit) > 1e3);
  ratio("critical time step", limit, 2. * std::sqrt(roller_mass / (1.5 * k)));
}
