// SPDX-License-Identifier: LGPL-2.1-or-later
// A point slides without friction down a drum, and down a ball, which is a surface of this test's
// own: it needs no more than project(). It leaves either where cos theta = 2/3 cos theta_0, with
// the angles from the top where it leaves and where it starts: there the weight's part towards the
// centre, m g cos theta, no longer bends its path, m v^2 / R = 2 m g (cos theta_0 - cos theta).
#include "../support/scenes.h"

#include <chaindrive/contact/drum.h>

using namespace test;

namespace
{
class Ball : public contact::Surface
{
public:
  Ball(const unsigned int body, const double radius) : Surface(body), radius_(radius) {}

  contact::Touch project(const World   &world,
                         const Vector3 &x,
                         const double   radius,
                         double /*within*/,
                         unsigned int & /*hint*/,
                         Projection & /*projection*/) const override
  {
    const Vector3  offset = x - world.frames[body()].position;
    contact::Touch touch;
    touch.gap = offset.norm() - radius_ - radius;
    if (touch.gap < 0.)
      {
        touch.normal = offset / offset.norm();
        touch.point  = x - radius * touch.normal;
        contact::set_tangents(touch, world.frames[body()]);
      }
    return touch;
  }

private:
  double radius_;
};

void slide(const std::string                             &name,
           const std::shared_ptr<const contact::Surface> &surface,
           const double                                   radius)
{
  const double m = 0.1, k = 1e7, g = 9.81, r = 0.01, start = 0.3, path = radius + r;
  const double sunk   = m * g * std::cos(start) / k; // starts in equilibrium on its spring
  scene::Scene scene  = empty_scene();
  scene.loads.gravity = g;
  scene.prestress     = 2. * m * g;
  scene.bodies        = {
             lump(m, (path - sunk) * vector(std::sin(start), std::cos(start))),
             ground(),
  };
  scene.surfaces = {on_surface(surface, {k, 0.2 * std::sqrt(k * m), 0., 0., 0.}, {{0, {}, r, 0}})};
  dynamics::System system(scene, false);
  const double     dt   = 1e-5;
  double           left = 0.;
  advance(system, 60000, dt, [&]() {
    const Vector3 &x = system.world.frames[0].position;
    if (left == 0. && system.contacts.families()[0]->records()[0].force.norm() == 0.)
      left = x[1] / x.norm();
  });
  ratio("leaves the " + name + " at cos theta", left, 2. / 3. * std::cos(start), 3);
}
} // namespace

int main()
{
  const double radius = 0.5;
  slide("drum", std::make_shared<const contact::Drum>(1, radius), radius);
  slide("ball", std::make_shared<const Ball>(1, radius), radius);
}
