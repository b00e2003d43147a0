// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic roller on the elastic teeth of an imported sprocket: what elastic_tooth shows of a
// generated one; and, at rest, pressed into the bottom of the seat and against one of its ends, the
// two deflect alike at equal fineness. As deep as a penetration may be, the force grows and is that
// of the exact arcs.
#include "../support/statics.h"
#include "../support/tooth.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/utilities/text.h>

using namespace test;

namespace
{
/// A roller pressed at its bore, at rest.
struct Pressed
{
  double force;      ///< on the roller, N
  double deflection; ///< of the teeth: work of the contact force on them over its size, m
};

/// The roller's bore has been moved by @p approach [m] from where it touches the seat at @p angle
/// [rad] from the bottom, away from the seat's centre.
Pressed press(Tooth c, const double angle, const double approach)
{
  const auto    chain        = drive::make_chain(parameters::Chain());
  const double  clearance    = 0.005 * chain.roller_diameter; // radial, of the least form
  const Vector3 direction    = vector(-std::cos(angle), std::sin(angle));
  const Vector3 moved        = (clearance + approach) * direction + vector(clearance - 5e-6, 0.);
  c.velocity                 = Vector3();
  const scene::Scene   scene = make_scene(c);
  World                world = make_world(scene);
  contact::NodeContact teeth(contact::on_flanks(scene.teeth[0], world), world, true);
  teeth.search(world, 1e-3);

  const mesh::Part &roller = *scene.parts.at(scene::Kind::roller),
                   &whole  = *scene.parts.at(scene::Kind::sprocket);
  const mesh::Nodes nodes(whole);
  const Hexahedra   roller_elements(roller, scene.material, Formulation::enhanced),
      teeth_elements(whole, nodes, scene.material, Formulation::enhanced);
  Statics            statics({&roller_elements, &teeth_elements});
  const auto        &sector  = *scene.sectors.at(scene::Kind::sprocket);
  BodyBatches       &rim     = world.copies[world.rims[0].group];
  const BodyBatches &rollers = world.copies[world.elastic_address[0].group];

  // positions and forces of both, whose numbers are those of the statics
  std::vector<double> start(statics.size, 0.);
  const auto          visit = [&](const auto &take) {
    for (unsigned int n = 0; n < rollers.n_nodes(); ++n)
      for (unsigned int d = 0; d < 3; ++d)
        take(3 * n + d,
             world.copies[world.elastic_address[0].group],
             rollers.index(0, n) + component_offset(d));
    for (unsigned int s = 0; s < rim.n_copies(); ++s)
      for (unsigned int n = 0; n < rim.n_nodes(); ++n)
        for (unsigned int d = 0; d < 3; ++d)
          take(statics.first[1] + 3 * nodes.of_vertex[sector.whole_vertex[s][rim.nodes.vertex[n]]] +
                   d,
               rim,
               rim.index(s, n) + component_offset(d));
  };
  visit([&](const unsigned int i, BodyBatches &copies, const std::size_t at) {
    start[i] = copies.position.local_element(at);
  });
  const auto contact = [&](const Vector<double> &u, Vector<double> &f) {
    visit([&](const unsigned int i, BodyBatches &copies, const std::size_t at) {
      copies.position.local_element(at) = start[i] + u[i];
      copies.force.local_element(at)    = 0.;
    });
    teeth.add_forces(world, 0.);
    f = 0.;
    visit([&](const unsigned int i, BodyBatches &copies, const std::size_t at) {
      f[i] += copies.force.local_element(at);
    });
  };

  std::vector<unsigned int> touched;
  const mesh::SurfaceNodes  bore(roller, rollers.nodes, mesh::roller_bore),
      outside(roller, rollers.nodes, mesh::roller_outside),
      flanks(whole, nodes, mesh::tooth_flanks);
  for (const unsigned int n : bore.node)
    for (unsigned int d = 0; d < 3; ++d)
      {
        statics.u[3 * n + d]    = moved[d];
        statics.held[3 * n + d] = true;
      }
  for (const unsigned int n : outside.node)
    {
      // a node that can come near the seat
      const Vector3 x = rollers.nodes.position[n];
      if (x * direction > 0.3 * x.norm())
        for (unsigned int d = 0; d < 3; ++d)
          touched.push_back(3 * n + d);
    }
  for (const unsigned int n : flanks.node)
    {
      const Vector3 x = nodes.position[n];
      if (std::abs(std::atan2(x[1], x[0])) < dealii::numbers::PI / 15.)
        for (unsigned int d = 0; d < 3; ++d)
          touched.push_back(statics.first[1] + 3 * n + d);
    }
  // half of them mirror the other half: which of two facets a node between them meets is left open
  for (unsigned int b = 0; b < 2; ++b)
    for (unsigned int n = 0; n < (b == 0 ? rollers.nodes : nodes).size(); ++n)
      if (std::abs((b == 0 ? rollers.nodes : nodes).position[n][2]) < 1e-9)
        statics.held[statics.first[b] + 3 * n + 2] = true;
  for (const unsigned int n : world.rims[0].border)
    for (unsigned int s = 0; s < rim.n_copies(); ++s)
      for (unsigned int d = 0; d < 3; ++d)
        statics.held[statics.first[1] +
                     3 * nodes.of_vertex[sector.whole_vertex[s][rim.nodes.vertex[n]]] + d] = true;

  // a node's force jumps by some newtons where it passes from one facet to the next, which have
  // other slopes: Newton's method ends there
  if (statics.solve(contact, touched, 3.) == 0)
    std::cout << "no equilibrium\n";
  Vector<double> f(statics.size);
  contact(statics.u, f);
  double work = 0.;
  for (unsigned int i = statics.first[1]; i < statics.size; ++i)
    work += f[i] * statics.u[i];
  const double force = teeth.records()[0].force.norm();
  return {force, work / force};
}

void compare(const double degrees)
{
  const double angle = degrees / 180. * dealii::numbers::PI, approach = 15e-6;
  Tooth        imported, generated;
  imported.sprocket    = Sprocket::imported;
  generated.refinement = 0;
  const Pressed a = press(imported, angle, approach), b = press(generated, angle, approach);
  std::cout << degrees
            << " degrees from the bottom of the seat, pressed in by 15 um: " << to_text(a.force, 2)
            << " N, teeth deflect by " << to_text(a.deflection * 1e6, 2) << " um\n";
  ratio("  force at the same approach, imported over generated", a.force, b.force);
  ratio("  deflection of the teeth, imported over generated", a.deflection, b.deflection);
}
/// Forces [N] of an undeformed roller at growing depths in the seat, up to a quarter of its radius.
std::vector<double> force_with_depth(const Sprocket sprocket, const bool elastic)
{
  Tooth c;
  c.sprocket                 = sprocket;
  c.elastic                  = elastic;
  c.velocity                 = Vector3();
  c.moved                    = vector(0., 3e-6);
  const scene::Scene   scene = make_scene(c);
  World                world = make_world(scene);
  contact::NodeContact teeth(contact::on_flanks(scene.teeth[0], world), world, true);
  BodyBatches         &rollers = world.copies[world.elastic_address[0].group];
  constexpr double     step    = 50e-6;
  std::vector<double>  forces;
  for (double depth = -5e-6; depth + step <= teeth.penetration_limit(); depth += step)
    {
      for (unsigned int n = 0; n < rollers.n_nodes(); ++n)
        NodeView(rollers.position).component(rollers.index(0, n), 0) -= step;
      world.frames[0].position[0] -= step;
      world.clear_forces();
      teeth.search(world, 1e-3);
      teeth.add_forces(world, 1e-6);
      forces.push_back(teeth.records()[0].force.norm());
    }
  return forces;
}

void compare_depths(const bool elastic)
{
  const std::vector<double> a = force_with_depth(Sprocket::imported, elastic),
                            b = force_with_depth(Sprocket::generated, elastic);
  bool   grows                = true;
  double difference           = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    {
      grows      = grows && a[i] > (i == 0 ? 0. : a[i - 1]);
      difference = std::max(difference, std::abs(a[i] / b[i] - 1.));
    }
  std::cout << (elastic ? "elastic" : "rigid") << " teeth, " << a.size() << " depths: ";
  verdict("the force grows up to a quarter of the radius", grows);
  verdict("  and is that of the arcs to 1e-5", difference < 1e-5);
}
} // namespace

int main()
{
  compare_depths(false);
  compare_depths(true);
  check_geometry(Sprocket::imported);
  check_balance(Sprocket::imported);

  Tooth elastic;
  elastic.sprocket = Sprocket::imported;
  verdict("imbalance below 0.5 % of the energy", press(elastic).worst < 5e-3);

  compare(0.);
  compare(50.);
}
