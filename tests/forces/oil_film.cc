// SPDX-License-Identifier: LGPL-2.1-or-later
// Oil that is squeezed out: resistance of films without flow along and across; a ring that sinks on
// its bush under its weight, h^(-1/2) = h0^(-1/2) + W t / 2A with A = 12 pi mu L (R/2)^(3/2); a
// roller that an impact sends into the seat of a tooth, which its film stops at h^(-1/2) =
// h0^(-1/2) + m v / 2A, energy and momentum; oil that does not pull; a film that is used up.
#include "../support/scenes.h"

#include <chaindrive/forces/oil_film.h>

using namespace test;
using dealii::numbers::PI;

namespace
{
constexpr double mass = 0.02, stiffness = 1e8;
constexpr double length = 10.; // so long that nothing flows along

double a_of(const double viscosity, const double radius)
{
  return 12. * PI * viscosity * length * std::pow(0.5 * radius, 1.5);
}

/// A ring of the bore 8 mm on a bush of 4 mm radius, whose centre is @p below that of the bush.
scene::Scene ring_on_bush(const double viscosity, const double below, const double speed)
{
  scene::Scene scene = empty_scene();
  scene.bodies       = {
            body(scene::Motion::rigid,
           scene::Mount::free(),
           mass,
           vector(1., 1., 1.),
           vector(0., -below, 0.),
           vector(0., speed, 0.)),
            body(scene::Motion::rigid, scene::Mount::fixed(), 1., vector(1., 1., 1.), Vector3())};
  scene::OilFilms films;
  films.viscosity       = viscosity;
  films.roller_radius   = 10e-3;
  films.bore_radius     = 8e-3;
  films.bush_radius     = 4e-3;
  films.length          = length;
  films.bush_stiffness  = stiffness;
  films.tooth_stiffness = stiffness;
  films.rollers         = {{0, 1, 0.}};
  scene.forces          = {std::make_shared<const OilFilm>(films)};
  return scene;
}

bool near(const double value, const double expected, const double share)
{
  return std::abs(value / expected - 1.) < share;
}
} // namespace

int main()
{
  // mu = 2, R = 5 mm, h = 0.1 mm
  const double is_long = 12. * PI * 2. * std::pow(25., 1.5),         // per length
      is_short         = 3. * PI / 8. * 2. * std::sqrt(0.01) * 1e10; // per its cube
  verdict("no flow along a long film",
          near(squeeze_resistance(2., 1e3, 5e-3, 1e-4, 1.), 1e3 * is_long, 1e-6));
  verdict("no flow across a short one",
          near(squeeze_resistance(2., 1e-6, 5e-3, 1e-4, 1.), 1e-18 * is_short, 1e-5));
  verdict("both resist side by side",
          near(squeeze_resistance(2., 1e-2, 5e-3, 1e-4, 1.),
               1. / (1. / (1e-2 * is_long) + 1. / (1e-6 * is_short)),
               1e-12));
  verdict("no wider than the roller",
          squeeze_resistance(2., 1e-2, 1e3, 1e-4, 2e-3) ==
              squeeze_resistance(2., 1e-2, 0.02, 1e-4, 2e-3));

  const double R = 8e-3 * 4e-3 / 4e-3, h0 = 0.2e-3, h1 = 0.05e-3;
  {
    scene::Scene scene  = ring_on_bush(1e-2, 4e-3 - h0, 0.);
    const double weight = mass * 9.81, A = a_of(1e-2, R);
    scene.loads.gravity = 9.81;
    dynamics::System system(scene, false);
    const double     time = 2. * A / weight * (1. / std::sqrt(h1) - 1. / std::sqrt(h0)), dt = 2e-6;
    advance(system, static_cast<unsigned long>(time / dt), dt, []() {});
    const double film = 4e-3 + system.world.frames[0].position[1] + weight / stiffness;
    ratio("sunk under its weight to", film, h1, 3);
    verdict("  energy to 1e-6 of what is lost",
            std::abs(system.world.ledger.imbalance()) <
                1e-6 * std::abs(system.world.ledger.spring_damping));
    ratio("  lost is the work of the weight",
          system.world.ledger.spring_damping,
          weight * (h0 - film),
          3);
  }

  // away from the bush's top: no force at all
  {
    dynamics::System system(ring_on_bush(1., 4e-3 - h1, 0.1), false);
    const double     dt = 1e-6;
    advance(system, 200, dt, []() {});
    verdict("oil does not pull",
            near(system.world.frames[0].velocity[1], 0.1, 1e-12) &&
                system.world.ledger.spring_damping == 0.);
  }

  // a roller, and a wheel that is as free as it
  for (const double dt : {2e-7, 1e-7})
    {
      Parameters                   parameters;
      const drive::ChainDimensions chain = drive::make_chain(parameters.drive.chain);
      scene::OilFilms              films;
      films.roller_radius   = 0.5 * chain.roller_diameter;
      films.bore_radius     = 1.;
      films.bush_radius     = 0.1; // far from everything
      films.length          = length;
      films.bush_stiffness  = stiffness;
      films.tooth_stiffness = 1e10;
      films.rollers         = {{0, 2, 0.}};
      films.wheels          = {
                   {1, length, drive::make_tooth_form(15, chain, parameters.drive.sprockets, 0)}};
      const drive::ToothForm &form = films.wheels[0].form;
      const double            gap = 15e-6, v = 0.05, // m/s
          radius =
              films.roller_radius * form.seat_radius / (form.seat_radius - films.roller_radius);
      // so much that it stops at h0 / 2.25: m v / 2A = 1 / 2 sqrt(h0)
      const double reduced  = 0.5 * mass;
      films.viscosity       = reduced * v * std::sqrt(gap) / a_of(1., radius);
      const double  x       = 0.5 * form.root_diameter + films.roller_radius + gap;
      scene::Scene  scene   = empty_scene();
      const Vector3 inertia = vector(1., 1., 1.);
      scene.bodies          = {
                   body(scene::Motion::rigid,
               scene::Mount::free(),
               mass,
               inertia,
               vector(x, 0., 0.),
               vector(-v, 0., 0.)),
                   body(scene::Motion::rigid, scene::Mount::free(), mass, inertia, Vector3()),
                   body(scene::Motion::rigid, scene::Mount::fixed(), 1., inertia, vector(0., 0., 5.))};
      scene.forces = {std::make_shared<const OilFilm>(films)};
      dynamics::System system(scene, false);
      double           least = gap;
      advance(system, static_cast<unsigned long>(4e-3 / dt), dt, [&]() {
        least = std::min(least,
                         system.world.frames[0].position[0] - system.world.frames[1].position[0] -
                             x + gap);
      });
      const double stop = gap / 2.25;
      ratio("roller in the seat stopped at", least, stop, 3);
      verdict(
          "  momentum",
          near(system.world.frames[0].velocity[0] + system.world.frames[1].velocity[0], -v, 1e-9));
      verdict("  energy to 1e-6 of what it was",
              std::abs(system.world.ledger.imbalance()) < 1e-6 * 0.25 * mass * v * v);
    }

  // a film that a heavy load uses up, surfaces that overlap: contact has what is left
  SqueezedFilm film;
  film.advance(1e-6, 1e6, 1e3, 0.);
  double gap = 1e-6, lost = 0., work = 0.;
  for (int i = 0; i < 20000; ++i)
    {
      const double before = film.force;
      gap                 = std::max(gap - 1e-9, -5e-6);
      const double change = film.gap - gap;
      lost += film.advance(gap, 1e6, 1e3, 1e-7);
      work += 0.5 * (before + film.force) * change;
    }
  verdict("a film is used up", film.thickness == 0. && film.force == 0. && film.stored == 0.);
  verdict("  what it has done is lost", lost > 0. && near(lost, work, 1e-9));

  // pressed down to less than a micrometre, opened to five in one short step, pressed again
  SqueezedFilm again;
  again.advance(1e-6, 1e6, 1e-3, 0.);
  again.advance(0.5e-6, 1e6, 1e-3, 1e-3);
  const double thin = again.thickness;
  again.advance(5e-6, 1e6, 1e3, 1e-9);
  verdict("a gap that opens is full at once",
          thin < 0.6e-6 && again.thickness == 5e-6 && again.force == 0.);
  again.advance(4e-6, 1e6, 1e3, 1e-9);
  verdict("  and bears where it closes again", near(again.force, 1e6 * 1e-6, 1e-3));
}
