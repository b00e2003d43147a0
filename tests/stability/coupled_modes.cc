// SPDX-License-Identifier: LGPL-2.1-or-later
// Two reduced links whose pins touch a quarter of their bushes, about any of 16 directions, in a
// chain whose next pitch moves alike or in opposition: of all 512 ways to close the two joints the
// search finds one that is as fast as the fastest, and far faster than the slowest.
#include "../support/reduced.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/contacts.h>
#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/stability/coupled_modes.h>

using namespace test;

namespace
{
scene::Scene make_scene(const scene::ContactLaw &law)
{
  scene::Scene   scene = empty_scene();
  const Material steel;
  const auto     chain = drive::make_chain(parameters::Chain());
  const double   at    = 0.5 * chain.inner_hole_pitch;
  const auto     add   = [&](const scene::Kind kind, const double x) {
    scene.bodies.push_back(body(scene::Motion::elastic,
                                scene::Mount::free(),
                                scene.parts.at(kind)->meshed.mass,
                                vector(1., 1., 1.),
                                vector(x, 0.)));
    scene.bodies.back().kind = kind;
  };
  scene.parts[scene::Kind::inner_link] = std::make_shared<const mesh::Part>(
      mesh::make_inner_link(chain, steel.density, mesh::inner_link_grid(0)));
  scene.parts[scene::Kind::outer_link] = std::make_shared<const mesh::Part>(
      mesh::make_outer_link(chain, steel.density, mesh::outer_link_grid(0)));
  add(scene::Kind::inner_link, 0.);

  scene::BoreFamily joint;
  joint.name       = "bush-pin";
  joint.elastic    = true;
  joint.law        = law;
  joint.half_angle = 0.25 * dealii::numbers::PI;
  for (const bool ahead : {false, true})
    {
      const double side = ahead ? 1. : -1.;
      add(scene::Kind::outer_link, side * (at + 0.5 * chain.outer_hole_pitch));
      joint.pairs.push_back({0,
                             dealii::Point<3>(side * at, 0., 0.),
                             0.5 * chain.bush_bore,
                             {ahead ? 2u : 1u,
                              dealii::Point<3>(-side * 0.5 * chain.outer_hole_pitch, 0., 0.),
                              0.5 * chain.pin_diameter,
                              ahead ? 1u : 0u},
                             ahead ? mesh::bush_bore_second : mesh::bush_bore_first,
                             ahead ? mesh::pin_outside_first : mesh::pin_outside_second});
    }
  scene.bores.push_back(joint);
  reduce(scene);
  return scene;
}
} // namespace

int main()
{
  for (const auto &[name, law] :
       {std::make_pair("frictionless", scene::ContactLaw{1e14, 0., 0., 0., 0.}),
        std::make_pair("with friction", scene::ContactLaw{1e14, 0., 0.3, 0.8e14, 0.})})
    {
      const scene::Scene                 scene = make_scene(law);
      World                              world = make_world(scene, MPI_COMM_SELF);
      const contact::Contacts            contacts(scene, world, false);
      std::vector<stability::ClosedKind> kinds;
      for (const auto &family : contacts.families())
        for (stability::ClosedKind &kind : stability::closed_kinds(world, *family))
          kinds.push_back(std::move(kind));
      const auto modes = stability::CoupledModes::make(world, kinds);
      verdict(std::string(name) + ": coupled", modes.has_value());
      const auto  &joints = modes->interfaces();
      const double dt = modes->free_step(), found = modes->eigenvalue(modes->find_worst(dt), dt);
      std::cout << joints.size() << " joints with " << joints[0].ways.size() << " and "
                << joints[1].ways.size() << " ways\n";

      double largest = 0., smallest = 1e300;
      for (unsigned int i = 0; i < joints[0].ways.size(); ++i)
        for (unsigned int j = 0; j < joints[1].ways.size(); ++j)
          {
            const double value = modes->eigenvalue({i, j}, dt);
            largest            = std::max(largest, value);
            smallest           = std::min(smallest, value);
          }
      ratio("frequency found, over the largest", std::sqrt(found), std::sqrt(largest), 3);
      verdict("the slowest way is more than 0.1 % below",
              std::sqrt(smallest) < 0.999 * std::sqrt(largest));
      verdict("the step is that of the way found",
              std::abs(modes->critical_time_step() * std::sqrt(found) / 2. - 1.) < 1e-5);
    }
}
