// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Small scenes for closed-form cases: a few bodies, one interface, one load.

#include "basics.h"

#include <chaindrive/contact/plane.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <iomanip>
#include <iostream>

namespace test
{
using namespace chaindrive;
using Vector3 = dealii::Tensor<1, 3>;

/// A scene with nothing in it: no gravity, no drag, a drive that stands still and is not loaded.
inline scene::Scene empty_scene()
{
  scene::Scene scene;
  scene.loads.gravity = scene.loads.drag = 0.;
  return scene;
}

inline scene::Body body(const scene::Motion motion,
                        const scene::Mount &mount,
                        const double        mass,
                        const Vector3      &inertia,
                        const Vector3      &position,
                        const Vector3      &velocity = Vector3())
{
  scene::Body body;
  body.kind             = scene::Kind::roller;
  body.number           = 0;
  body.motion           = motion;
  body.mount            = mount;
  body.mass             = mass;
  body.inertia          = inertia;
  body.initial.position = position;
  body.initial.velocity = velocity;
  body.initial.rotation = to_matrix(Quaternion());
  return body;
}

inline scene::Body
lump(const double mass, const Vector3 &position, const Vector3 &velocity = Vector3())
{
  return body(scene::Motion::lumped, scene::Mount::free(), mass, Vector3(), position, velocity);
}

/// A body turned about z by the speed program; with a drive that stands still, the fixed ground.
inline scene::Body ground()
{
  return body(scene::Motion::rigid, scene::Mount::motor(), 1., vector(1., 1., 1.), Vector3());
}

/// Turns @p body, which is on a hub, by @p speed [rad/s] over time, in the sense of @p sense.
inline void turn(scene::Scene             &scene,
                 const unsigned int        body,
                 const functions::Pointer &speed,
                 const int                 sense = 1)
{
  drive::ShaftProgram program;
  program.speed = speed;
  scene.shafts.push_back({body, sense, program});
}

/// The plane through the origin of @p body with the @p normal out of its material.
inline std::shared_ptr<const contact::Surface> plane(const unsigned int body, const Vector3 &normal)
{
  return std::make_shared<const contact::Plane>(body, dealii::Point<3>(), normal);
}

/// Slave points on a surface.
inline scene::SurfaceFamily on_surface(std::shared_ptr<const contact::Surface> surface,
                                       const scene::ContactLaw                &law,
                                       const std::vector<scene::SlavePoint>   &slaves)
{
  return {"surface", std::move(surface), law, slaves};
}

/// Advances @p system by @p n steps of @p dt [s] from its present time, calling @p look after each.
template <typename Look>
void advance(dynamics::System &system, const unsigned long n, const double dt, const Look &look)
{
  const double start = system.world.time;
  for (unsigned long i = 1; i <= n; ++i)
    {
      system.advance(dt, start + i * dt);
      look();
    }
}

/// A line of a test's output: what was obtained over what was expected.
inline void
ratio(const std::string &what, const double obtained, const double expected, const int digits = 4)
{
  std::cout << what << ": " << std::fixed << std::setprecision(digits) << obtained / expected
            << std::defaultfloat << " of the expected value\n";
}
} // namespace test
