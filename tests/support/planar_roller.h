// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// A rigid roller in the plane, on the bush in its bore or between teeth that stand.

#include "scenes.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/drive.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace test::planar_roller
{
constexpr double mass = 2e-3, bore_radius = 3.76e-3, bush_radius = 3.7e-3, radius = 5.08e-3,
                 k = 2e8; // N/m, of each contact

/// A bush of @p bush_mass [kg], body 1, in the bore of the roller, body 0; both at rest.
inline scene::Scene
roller_and_bush(const double bush_mass, const Vector3 &roller_at, const Vector3 &bush_at)
{
  scene::Scene scene = empty_scene();
  scene.prestress    = 1e9; // overlaps are meant
  scene.planar       = true;
  scene.bodies       = {
            body(scene::Motion::rigid, scene::Mount::free(), mass, vector(1e-8, 1e-8, 2e-8), roller_at),
            body(scene::Motion::rigid,
           scene::Mount::free(),
           bush_mass,
           vector(1e-7, 1e-7, 2e-7),
           bush_at)};
  scene.bodies[1].kind   = scene::Kind::inner_link;
  scene.bodies[1].number = 0;
  scene.bores            = {{"roller-bush",
                             scene::Interface::roller_bush,
                             {k, 0., 0., 0., 0.},
                             {{0, dealii::Point<3>(), bore_radius, {1, dealii::Point<3>(), bush_radius, 0}}}}};
  return scene;
}

inline drive::ToothForm form()
{
  parameters::Sprockets sprockets;
  sprockets.driver().outside_diameter = 81e-3;
  return drive::make_tooth_form(15, drive::make_chain(parameters::Chain()), sprockets, 0);
}

/// Adds a sprocket of this @p form that stands, whose teeth the roller meets.
inline void add_teeth(scene::Scene &scene, const drive::ToothForm &form)
{
  const auto sprocket = static_cast<unsigned int>(scene.bodies.size());
  scene.bodies.push_back(ground());
  scene.bodies.back().kind = scene::Kind::sprocket;
  scene::ToothFamily teeth;
  teeth.name         = "roller-driver";
  teeth.sprocket     = sprocket;
  teeth.form         = std::make_shared<const drive::ToothForm>(form);
  teeth.teeth        = form.teeth;
  teeth.outer_radius = 0.5 * form.outside_diameter;
  teeth.half_width   = 4e-3;
  teeth.law          = {k, 0., 0., 0., 0.};
  teeth.slaves       = {{0, dealii::Point<3>(), radius, 0}};
  scene.teeth        = {teeth};
}

/// The @p scene has a bush, a roller and teeth, which then turn; all are thrown at each other for
/// 150 us: the largest imbalance over their energy.
inline double thrown_together(scene::Scene scene, const double dt)
{
  scene.bodies[1].initial.velocity = vector(-2., 0.7);
  scene.bodies[0].initial.velocity = vector(-0.5, -0.4);
  turn(scene, 2, std::make_shared<functions::Constant>(120.));
  dynamics::System system(scene, false);
  double           worst = 0.;
  advance(system, static_cast<unsigned long>(150e-6 / dt), dt, [&]() {
    worst = std::max(worst, std::abs(system.world.ledger.imbalance()));
  });
  return worst / system.world.ledger.initial;
}
} // namespace test::planar_roller
