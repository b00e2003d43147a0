// SPDX-License-Identifier: LGPL-2.1-or-later
// A roller shrunk onto the bush of an inner link, and a piece of chain with its pins shrunk into
// bushes, too: all nodes of the joints stay closed. The critical time step that is printed is safe,
// and not far below the one at which the bodies blow up. With an argument: for so many steps, and
// with the share of the limit at which they do.
#include "../support/blow_up.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>

using namespace test;

namespace
{
scene::Scene
make_scene(const mesh::RollerGrid &grid, const double stiffness, const scene::ContactLaw &ratios)
{
  scene::Scene   scene = empty_scene();
  const Material steel;
  const auto     chain = drive::make_chain(parameters::Chain());
  auto           tight = chain;
  tight.roller_bore    = chain.bush_diameter - 4e-6;
  const auto add       = [&](const scene::Kind kind, mesh::Part &&part, const double x) {
    scene.bodies.push_back(body(scene::Motion::elastic,
                                scene::Mount::free(),
                                part.meshed.mass,
                                vector(1., 1., 1.),
                                vector(x, 0.)));
    scene.bodies.back().kind = kind;
    scene.parts[kind]        = std::make_shared<const mesh::Part>(std::move(part));
  };
  add(scene::Kind::inner_link,
      mesh::make_inner_link(chain, steel.density, mesh::inner_link_grid(0)),
      0.);
  add(scene::Kind::roller,
      mesh::make_roller(tight, steel.density, grid),
      -0.5 * chain.inner_hole_pitch);

  scene::BoreFamily joint;
  joint.name    = "roller-bush";
  joint.elastic = true;
  joint.law     = {stiffness,
                   ratios.damping * stiffness,
                   ratios.friction,
                   ratios.tangential_stiffness * stiffness,
                   ratios.tangential_damping * stiffness};
  joint.pairs.push_back({1,
                         dealii::Point<3>(),
                         0.5 * tight.roller_bore,
                         {0, dealii::Point<3>(-0.5 * chain.inner_hole_pitch, 0., 0.), 0., 0},
                         mesh::roller_bore,
                         mesh::bush_outside_first});
  scene.bores.push_back(joint);
  scene.prestress  = 1e9; // the overlap is meant
  scene.loads.drag = 2e5; // the shrunk parts come to rest; it takes a hundredth of the limit
  return scene;
}

/// A piece of chain: that, a roller on the other bush, and outer links with their pins shrunk into
/// the bushes.
scene::Scene
make_chain(const mesh::RollerGrid &grid, const double stiffness, const scene::ContactLaw &ratios)
{
  scene::Scene   scene = make_scene(grid, stiffness, ratios);
  const Material steel;
  const auto     chain = drive::make_chain(parameters::Chain());
  auto           tight = chain;
  tight.pin_diameter   = chain.bush_bore + 4e-6;
  const double at      = 0.5 * chain.inner_hole_pitch;

  scene::Body roller = scene.bodies[1];
  roller.initial.position[0] += chain.inner_hole_pitch;
  scene.bodies.push_back(roller);
  scene::BorePair second = scene.bores[0].pairs[0];
  second.master          = 2;
  second.slave.point     = dealii::Point<3>(at, 0., 0.);
  second.slave_surface   = mesh::bush_outside_second;
  scene.bores[0].pairs.push_back(second);

  auto              part  = mesh::make_outer_link(tight, steel.density, mesh::outer_link_grid(0));
  scene::BoreFamily joint = scene.bores[0];
  joint.name              = "bush-pin";
  joint.pairs.clear();
  for (const bool ahead : {false, true})
    {
      const double centre = (ahead ? 1. : -1.) * (at + 0.5 * chain.outer_hole_pitch);
      scene.bodies.push_back(body(scene::Motion::elastic,
                                  scene::Mount::free(),
                                  part.meshed.mass,
                                  vector(1., 1., 1.),
                                  vector(centre, 0.)));
      scene.bodies.back().kind = scene::Kind::outer_link;
      joint.pairs.push_back(
          {0,
           dealii::Point<3>(ahead ? at : -at, 0., 0.),
           0.5 * chain.bush_bore,
           {ahead ? 4u : 3u,
            dealii::Point<3>((ahead ? -0.5 : 0.5) * chain.outer_hole_pitch, 0., 0.),
            0.5 * tight.pin_diameter,
            ahead ? 1u : 0u},
           ahead ? mesh::bush_bore_second : mesh::bush_bore_first,
           ahead ? mesh::pin_outside_first : mesh::pin_outside_second});
    }
  scene.parts[scene::Kind::outer_link] = std::make_shared<const mesh::Part>(std::move(part));
  scene.bores.push_back(joint);
  return scene;
}
} // namespace

int main(int argc, char **argv)
{
  const unsigned long steps = argc > 1 ? std::stoul(argv[1]) : 5000;
  struct Case
  {
    std::string       name;
    mesh::RollerGrid  grid;
    double            stiffness;
    scene::ContactLaw ratios;
    bool              reduced = false, chain = false, mixed = false;
  };
  const double tau = 4e-8;
  for (const Case &c :
       {Case{"one element through the wall", {1, 24, 4}, 1e14, {1., 0., 0., 0., 0.}},
        Case{"three elements through the wall", {3, 24, 4}, 1e14, {1., 0., 0., 0., 0.}},
        Case{"three, damped", {3, 24, 4}, 1e14, {1., tau, 0., 0., 0.}},
        Case{"three, damped, friction", {3, 24, 4}, 1e14, {1., tau, 0.3, 0.8, tau}},
        Case{"three, ten times as stiff", {3, 24, 4}, 1e15, {1., 0., 0., 0., 0.}},
        Case{"one, ten times as stiff, damped", {1, 24, 4}, 1e15, {1., 0.1 * tau, 0., 0., 0.}},
        Case{"three, finer along than the bush", {3, 24, 6}, 1e15, {1., 0., 0., 0., 0.}},
        Case{"three, finer than the bush", {3, 32, 6}, 1e14, {1., 0., 0., 0., 0.}},
        Case{"one, coarser than the bush", {1, 16, 2}, 1e15, {1., 0., 0., 0., 0.}},
        Case{"reduced", {3, 24, 4}, 1e14, {1., 0., 0., 0., 0.}, true},
        Case{"reduced, damped", {3, 24, 4}, 1e14, {1., tau, 0., 0., 0.}, true},
        Case{"reduced, friction", {3, 24, 4}, 1e14, {1., 0., 0.3, 0.8, 0.}, true},
        Case{"reduced chain", {3, 24, 4}, 1e14, {1., 0., 0., 0., 0.}, true, true},
        Case{"reduced chain, damped", {3, 24, 4}, 1e14, {1., tau, 0.3, 0.8, tau}, true, true},
        Case{"reduced link, roller of elements",
             {3, 24, 4},
             1e14,
             {1., tau, 0.3, 0.8, tau},
             true,
             false,
             true}})
    {
      scene::Scene scene = c.chain ? make_chain(c.grid, c.stiffness, c.ratios) :
                                     make_scene(c.grid, c.stiffness, c.ratios);
      if (c.reduced)
        {
          const scene::Body roller = scene.bodies[1];
          reduce(scene);
          if (c.mixed)
            scene.bodies[1] = roller;
        }
      const double share = blow_up(scene, 2000, steps);
      verdict(c.name + ": bounded at 0.98 of the limit", share > 0.99);
      const bool coupled = c.reduced && !c.mixed;
      verdict(c.name + ": the limit is less than " + (coupled ? "8" : "15") + " % below",
              share < 1. / (coupled ? 0.92 : 0.85));
      if (argc > 1)
        std::cout << c.name << ": blows up at " << share << " of the limit\n";
    }
}
