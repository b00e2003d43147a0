// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic link and a rigid one, joined by a pin in a bush, fly apart until the joint is taut,
// and rebound, tilted: the rigid body's mesh follows it and touches node by node. What one gains in
// momentum and in angular momentum the other loses, whichever of the two is elastic. The energy
// closes: in a rigid bore, which keeps its shape, with the square of the step.
#include "../support/scenes.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>

using namespace test;

namespace
{
struct Result
{
  double momentum = 0., moment = 0., energy = 0., force = 0.; ///< largest errors, relative; N
};

Result run(const bool bush_is_elastic, const double friction, const double share_of_limit)
{
  const parameters::Material steel;
  const auto                 chain = drive::make_chain(parameters::Chain());
  scene::Scene               scene = empty_scene();
  const auto                 add =
      [&](const scene::Kind kind, mesh::Part &&part, const double x, const bool elastic) {
        scene::Body link = body(elastic ? scene::Motion::elastic : scene::Motion::rigid,
                                scene::Mount::free(),
                                part.meshed.mass,
                                Vector3(),
                                vector(x, 0.));
        link.kind = kind;
        for (unsigned int d = 0; d < 3; ++d)
          link.inertia[d] = part.meshed.inertia[d][d];
        scene.parts[kind] = std::make_shared<const mesh::Part>(std::move(part));
        scene.bodies.push_back(link);
      };
  const double bush = 0.5 * chain.inner_hole_pitch, pin = 0.5 * chain.outer_hole_pitch;
  add(scene::Kind::inner_link,
      mesh::make_inner_link(chain, steel.density, mesh::inner_link_grid(0)),
      0.,
      bush_is_elastic);
  add(scene::Kind::outer_link,
      mesh::make_outer_link(chain, steel.density, mesh::outer_link_grid(0)),
      bush + pin,
      !bush_is_elastic);
  scene.bodies[1].initial.velocity         = vector(2., 0.7, 0.3);
  scene.bodies[1].initial.angular_velocity = vector(60., 30., 100.);

  scene::BoreFamily joint;
  joint.name    = "bush-pin";
  joint.elastic = true;
  joint.law     = {1e14, 1e6, friction, 0.7e14, 0.7e6};
  joint.pairs.push_back({0,
                         dealii::Point<3>(bush, 0., 0.),
                         0.5 * chain.bush_bore,
                         {1, dealii::Point<3>(), 0.5 * chain.pin_diameter, 0},
                         mesh::bush_bore_second,
                         mesh::pin_outside_first});
  scene.bores.push_back(joint);

  dynamics::System system(scene, false);
  const double     dt     = share_of_limit * system.critical_time_step();
  const double     energy = system.world.kinetic_energy() + system.world.ledger.kinetic;

  // half a step ahead: nodes with their velocities, the rigid body from its forces
  const auto momenta = [&]() {
    const World       &world = system.world;
    Vector3            p, l;
    const BodyBatches &nodes = world.copies[0];
    for (unsigned int node = 0; node < nodes.n_nodes(); ++node)
      {
        Vector3 x, v;
        for (unsigned int d = 0; d < 3; ++d)
          {
            x[d] = NodeView(nodes.position).component(nodes.index(0, node), d);
            v[d] = NodeView(nodes.velocity).component(nodes.index(0, node), d);
          }
        p += nodes.nodes.mass[node] * v;
        l += nodes.nodes.mass[node] * cross_product_3d(x, v);
      }
    const World::Rotation &rigid = world.rotations.front();
    const Frame           &frame = world.frames[rigid.body];
    Vector3                force, moment;
    for (unsigned int d = 0; d < 3; ++d)
      {
        force[d]  = world.force.local_element(3 * rigid.body + d);
        moment[d] = world.moment.local_element(3 * rigid.body + d);
      }
    const Vector3 of_rigid = world.mass[rigid.body] * frame.velocity + 0.5 * dt * force;
    p += of_rigid;
    l += cross_product_3d(frame.position, of_rigid) + rigid.momentum + 0.5 * dt * moment;
    return std::make_pair(p, l);
  };

  Result                      result;
  std::pair<Vector3, Vector3> start;
  bool                        first = true;
  advance(system, static_cast<unsigned long>(120e-6 / dt), dt, [&]() {
    const auto now = momenta();
    if (first)
      start = now;
    first = false;
    result.momentum =
        std::max(result.momentum, (now.first - start.first).norm() / start.first.norm());
    result.moment =
        std::max(result.moment, (now.second - start.second).norm() / start.second.norm());
    result.energy = std::max(result.energy, std::abs(system.world.ledger.imbalance()) / energy);
    result.force = std::max(result.force, system.contacts.families()[0]->records()[0].force.norm());
  });
  return result;
}
} // namespace

int main()
{
  for (const bool bush : {true, false})
    for (const double friction : {0., 0.2})
      {
        const Result coarse = run(bush, friction, 0.8);
        // friction between two radii has a couple of its own, which is exact for rigid bores only
        const double exact = bush && friction > 0. ? 1e-6 : 1e-12;
        std::cout << (bush ? "elastic bush, rigid pin" : "rigid bush, elastic pin") << ", friction "
                  << friction << '\n'
                  << "  they meet with more than 1000 N: " << (coarse.force > 1e3 ? "yes" : "no")
                  << '\n'
                  << "  momentum kept to 1e-12: " << (coarse.momentum < 1e-12 ? "yes" : "no")
                  << '\n'
                  << "  angular momentum kept to " << exact << ": "
                  << (coarse.moment < exact ? "yes" : "no") << '\n'
                  << "  energy closes to 3e-4: " << (coarse.energy < 3e-4 ? "yes" : "no") << '\n';
        if (!bush)
          {
            const double order = std::log2(coarse.energy / run(bush, friction, 0.4).energy);
            std::cout << "  order of its error in the step from 1.8 to 2.2: "
                      << (order > 1.8 && order < 2.2 ? "yes" : "no") << '\n';
          }
      }
}
