// SPDX-License-Identifier: LGPL-2.1-or-later
// A cylinder lies in a bore that turns: friction spins it up until it rolls, w r = W R. The bore is
// smooth, so the contact force stays at m g with no ripple from facets.
#include "../support/scenes.h"

using namespace test;

int main()
{
  const double m = 3.4e-3, g = 9.81, bush = 3.715e-3, bore = 3.76e-3, inertia = 2.4e-8, k = 1e6;
  scene::Scene scene  = empty_scene();
  scene.loads.gravity = g;
  scene.loads.drag    = 100.; // lets the swinging about the bottom of the bore die out
  turn(scene, 1, std::make_shared<functions::Ramp>(120.74, 0., 20e-3, functions::Rise::cosine));
  scene.bodies = {body(scene::Motion::rigid,
                       scene::Mount::free(),
                       m,
                       vector(inertia, inertia, inertia),
                       vector(0., -(bore - bush) - 0.9e-9)),
                  ground()};
  const scene::ContactLaw law{
      k / 2, 0.5 * std::sqrt(k * m), 0.3, 0.8 * k / 2, 0.5 * std::sqrt(k * m)};
  scene.bores = {{"bore",
                  scene::Interface::other,
                  law,
                  {{1, dealii::Point<3>(), bore, {0, dealii::Point<3>(0., 0., 2e-3), bush, 0}},
                   {1, dealii::Point<3>(), bore, {0, dealii::Point<3>(0., 0., -2e-3), bush, 0}}}}};
  dynamics::System system(scene, false);
  const double     dt = 2e-6;
  advance(system, 250000, dt, []() {}); // spun up and settled
  double least = 1e9, most = 0.;
  advance(system, 50000, dt, [&]() {
    const auto  &records = system.contacts.families()[0]->records();
    const double normal =
        records[0].force * records[0].normal + records[1].force * records[1].normal;
    least = std::min(least, normal);
    most  = std::max(most, normal);
  });
  ratio("rolling speed", system.world.frames[0].angular_velocity[2] * bush, 120.74 * bore, 4);
  ratio("contact force", 0.5 * (least + most), m * g, 3);
  verdict("ripple of the contact force below 1 %", most - least < 0.01 * m * g);
  std::cout << "turns of the bore meanwhile: " << std::setprecision(2)
            << 0.1 * 120.74 / (2. * dealii::numbers::PI) << '\n';
}
