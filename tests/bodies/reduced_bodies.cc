// SPDX-License-Identifier: LGPL-2.1-or-later
// Reduced bodies in free flight, more than one batch, spinning and ringing in all modes. Nodes are
// where their modes put them: their momentum is the body's, the elements resist a mode as its
// frequency says, and their velocities are secants of their paths. Over 100,000 steps
// momentum and angular momentum stay, and the energy of central differences does not drift. What
// was written to an archive goes on bit by bit.
#include "../support/archive.h"
#include "../support/reduced.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/surface/surface_nodes.h>

#include <algorithm>

using namespace test;

namespace
{
constexpr unsigned int n_copies = 11;

scene::Scene make_scene()
{
  scene::Scene scene                   = empty_scene();
  const auto   chain                   = drive::make_chain(parameters::Chain());
  scene.parts[scene::Kind::inner_link] = std::make_shared<const mesh::Part>(
      mesh::make_inner_link(chain, scene.material.density, mesh::inner_link_grid(0)));
  for (unsigned int k = 0; k < n_copies; ++k)
    {
      scene::Body link              = body(scene::Motion::elastic,
                              scene::Mount::free(),
                              0.,
                              Vector3(),
                              vector(0.1 + 0.02 * k, 0.3, -0.1 * k),
                              vector(4. - k, 2. + 0.5 * k, 1.));
      link.kind                     = scene::Kind::inner_link;
      link.initial.rotation         = to_matrix(rotation_by(vector(0.1 * k, 0.2, 0.7 * k)));
      link.initial.angular_velocity = link.initial.rotation * vector(3. * k, -20., 40. + 30. * k);
      scene.bodies.push_back(link);
    }
  reduce(scene);
  scene.bodies.push_back(ground());
  auto far = on_surface(plane(n_copies, vector(0., 1., 0.)), {1., 0., 0., 0., 0.}, {});
  for (unsigned int k = 0; k < n_copies; ++k)
    far.slaves.push_back({k, dealii::Point<3>(), 1e-3, k});
  far.elastic       = true;
  far.slave_surface = mesh::bush_outside_first;
  scene.surfaces    = {far};
  return scene;
}

/// All modes ring, natural ones with most energy.
void excite(dynamics::System &system, const double dt)
{
  ReducedBodies &group = reduced_group(system.world, 0);
  for (unsigned int copy = 0; copy < n_copies; ++copy)
    for (unsigned int m = 0; m < group.n_modes(); ++m)
      {
        const double phase                     = 0.3 * copy + 1.7 * m;
        group.rate(system.world, copy, m)      = 1e-2 * std::sin(phase);
        group.amplitude(system.world, copy, m) = 1e-2 * std::cos(phase) / group.omega(m);
      }
  system.evaluate_forces(0.);
  system.advance(dt, dt);
}

/// Of each copy and mode, what central differences keep: q'^2 + W^2 q^2 (1 - (W dt / 2)^2).
std::vector<double> energies(dynamics::System &system, const double dt)
{
  ReducedBodies      &group = reduced_group(system.world, 0);
  std::vector<double> kept;
  for (unsigned int copy = 0; copy < n_copies; ++copy)
    for (unsigned int m = 0; m < group.n_modes(); ++m)
      {
        const double w = group.omega(m), h = 0.5 * w * dt;
        kept.push_back(std::pow(group.rate(system.world, copy, m), 2) +
                       std::pow(w * group.amplitude(system.world, copy, m), 2) * (1. - h * h));
      }
  return kept;
}

/// Places all nodes where they are now, with their velocities.
void place_all_nodes(World &world)
{
  const ReducedBodies &group  = reduced_group(world, 0);
  BodyBatches         &copies = world.copies[0];
  for (unsigned int copy = 0; copy < n_copies; ++copy)
    for (unsigned int n = 0; n < copies.n_nodes(); ++n)
      {
        NodeView(copies.position).set(copies.index(copy, n), group.position_now(world, copy, n));
        NodeView(copies.velocity).set(copies.index(copy, n), group.velocity_now(world, copy, n));
      }
}

/// Nodes of @p copy: mass, position, velocity, where they were placed.
template <typename Visit>
void for_each_node(const World &world, const unsigned int copy, const Visit &visit)
{
  const BodyBatches &copies = world.copies[0];
  for (unsigned int n = 0; n < copies.n_nodes(); ++n)
    visit(n,
          copies.nodes.mass[n],
          NodeView(copies.position)[copies.index(copy, n)],
          NodeView(copies.velocity)[copies.index(copy, n)]);
}

void look_at_nodes(const scene::Scene &scene)
{
  dynamics::System system(scene, false);
  World           &world = system.world;
  const double     dt    = 0.5 * system.critical_time_step();
  excite(system, dt);
  place_all_nodes(world);
  double               apart = 0.;
  std::vector<Vector3> positions, velocities;
  for (unsigned int copy = 0; copy < n_copies; ++copy)
    {
      reduced_group(world, 0).nodes_now(world, copy, positions, velocities);
      for_each_node(
          world, copy, [&](const unsigned int n, double, const Vector3 &x, const Vector3 &v) {
            apart = std::max({apart, (positions[n] - x).norm(), 1e-3 * (velocities[n] - v).norm()});
          });
    }
  verdict("all nodes at once are where they are one by one, to 1e-15 m and 1e-12 m/s",
          apart < 1e-15);
  double linear = 0., angular = 0., centre = 0.;
  for (unsigned int copy = 0; copy < n_copies; ++copy)
    {
      Vector3            p, spin, x_c;
      const unsigned int body  = world.copies[0].bodies[copy];
      const Frame       &frame = world.frames[body];
      for_each_node(world, copy, [&](unsigned int, double m, const Vector3 &x, const Vector3 &v) {
        p += m * v;
        x_c += m * (x - frame.position);
        spin += m * cross_product_3d(x - frame.position, v);
      });
      const double mass = world.mass[body];
      linear  = std::max(linear, (p / mass - frame.velocity).norm() / frame.velocity.norm());
      centre  = std::max(centre, x_c.norm() / mass);
      angular = std::max(angular, (spin - world.rotations[body].momentum).norm() / spin.norm());
    }
  verdict("momentum of the nodes is the body's to 1e-12", linear < 1e-12);
  verdict("their centre of mass is the body's to 1e-15 m", centre < 1e-15);
  verdict("their angular momentum is the body's to 1 %", angular < 1e-2);
}

void fly(scene::Scene scene)
{
  scene.surfaces.clear();
  dynamics::System system(scene, false);
  const World     &world = system.world;
  const double     dt    = 0.9 * system.critical_time_step();
  excite(system, dt);
  const auto                         before = energies(system, dt);
  const World::Vector                velocity(world.velocity);
  const std::vector<World::Rotation> rotations = world.rotations;
  double                             worst     = 0.;
  const double                       total     = world.ledger.stored();
  advance(system, 100000, dt, [&]() {
    worst = std::max(worst, std::abs(world.ledger.stored() - total));
  });
  double     drift = 0., linear = 0., angular = 0.;
  const auto after = energies(system, dt);
  for (unsigned int i = 0; i < after.size(); ++i)
    drift = std::max(drift, std::abs(after[i] / before[i] - 1.));
  for (unsigned int i = 0; i < 3 * world.n_bodies(); ++i)
    linear = std::max(linear,
                      std::abs(world.velocity.local_element(i) / velocity.local_element(i) - 1.));
  for (unsigned int i = 0; i < rotations.size(); ++i)
    angular = std::max(angular,
                       (world.rotations[i].momentum - rotations[i].momentum).norm() /
                           rotations[i].momentum.norm());
  verdict("100,000 steps: momentum kept to 1e-12", linear < 1e-12);
  verdict("  angular momentum kept to 1e-12", angular < 1e-12);
  verdict("  energy of each mode kept to 1e-10", drift < 1e-10);
  verdict("  and in all at full steps within 10 %", worst < 0.1 * total);
}
/// Largest error of the velocities of nodes that touch as secants, over the largest speed. They are
/// read for the first time before the step of @p dt or, if they are not @p known, at its end.
double secant_error(const scene::Scene &scene, const double dt, const bool known)
{
  dynamics::System system(scene, false);
  World           &world = system.world;
  excite(system, 1e-9);
  place_all_nodes(world);
  std::vector<Vector3> from;
  for (unsigned int copy = 0; copy < n_copies; ++copy)
    for_each_node(world, copy, [&](unsigned int, double, const Vector3 &x, const Vector3 &) {
      from.push_back(x);
    });
  const mesh::SurfaceNodes side(
      *world.copies[0].part, world.copies[0].nodes, mesh::bush_outside_first);
  const auto read = [&] {
    for (unsigned int batch = 0; batch < world.copies[0].n_batches(); ++batch)
      world.copies[0].add_readers(batch, side.node, 1);
  };
  if (known)
    read();
  dynamics::first_half(world, system.make_step(dt, world.time + dt));
  if (!known)
    read();
  world.place_surfaces(0.5 * dt);
  double       worst = 0., fastest = 0.;
  unsigned int i = 0;
  for (unsigned int copy = 0; copy < n_copies; ++copy)
    for_each_node(world, copy, [&](unsigned int n, double, const Vector3 &x, const Vector3 &v) {
      const Vector3 &before = from[i++];
      if (!std::binary_search(side.node.begin(), side.node.end(), n))
        return;
      worst   = std::max(worst, (x - before - dt * v).norm() / dt);
      fastest = std::max(fastest, v.norm());
    });
  return worst / fastest;
}

/// Work of the forces of the elements on nodes displaced by one natural mode: that of its
/// frequency.
void compare_with_elements(const scene::Scene &scene)
{
  dynamics::System           system(scene, false);
  World                     &world  = system.world;
  ReducedBodies             &group  = reduced_group(world, 0);
  const BodyBatches         &copies = world.copies[0];
  const element::ElasticPart part(*copies.part, copies.nodes, scene.material, scene.elements);
  const Frame               &frame = world.frames[0];
  double                     worst = 0.;
  std::vector<unsigned int>  slowest(group.n_modes());
  std::iota(slowest.begin(), slowest.end(), 0u);
  std::sort(slowest.begin(), slowest.end(), [&group](const unsigned int a, const unsigned int b) {
    return group.omega(a) < group.omega(b);
  });
  for (const unsigned int number : {0, 1, 5, 10})
    {
      const unsigned int m         = slowest[number];
      const double       q         = 3e-9;
      group.amplitude(world, 0, m) = q;
      place_all_nodes(world);
      BodyBatches::Vector            force(copies.force);
      alignas(64) element::BatchSums sums{};
      part.add_forces({copies.position.begin(),
                       force.begin(),
                       sums.strain,
                       sums.hourglass,
                       copies.velocity.begin(),
                       static_cast<unsigned int>(copies.stride())});
      double work = 0., expected = 0.;
      for_each_node(world, 0, [&](unsigned int n, double mass, const Vector3 &x, const Vector3 &) {
        const Vector3 u = x - frame.position - frame.rotation * Vector3(copies.nodes.position[n]);
        work -= NodeView(force)[copies.index(0, n)] * u;
        expected += std::pow(group.omega(m), 2) * mass * u.norm_square();
      });
      worst                        = std::max(worst, std::abs(work / expected - 1.));
      group.amplitude(world, 0, m) = 0.;
    }
  verdict("elements resist a natural mode as its frequency says to 1e-6", worst < 1e-6);
}

void resume(const scene::Scene &scene)
{
  dynamics::System through(scene, false);
  const double     dt = 0.9 * through.critical_time_step();
  excite(through, dt);
  Items items;
  through.serialize(writer(items));
  dynamics::System resumed(scene, false);
  resumed.serialize(reader(items));
  for (dynamics::System *system : {&through, &resumed})
    advance(*system, 50, dt, [] {});
  place_all_nodes(through.world);
  place_all_nodes(resumed.world);
  bool same = true;
  for (unsigned int i = 0; i < through.world.copies[0].position.locally_owned_size(); ++i)
    same = same &&
           through.world.copies[0].position.local_element(i) ==
               resumed.world.copies[0].position.local_element(i) &&
           through.world.copies[0].velocity.local_element(i) ==
               resumed.world.copies[0].velocity.local_element(i);
  verdict("resumed bit by bit",
          same && through.world.ledger.kinetic == resumed.world.ledger.kinetic);
}
} // namespace

int main()
{
  const scene::Scene scene = make_scene();
  look_at_nodes(scene);
  compare_with_elements(scene);
  verdict("velocities of nodes that were placed before are secants to 1e-8",
          secant_error(scene, 2e-7, true) < 1e-8);
  verdict("  and those of others to the second order in the step",
          secant_error(scene, 2e-7, false) < std::pow(0.5, 1.9) * secant_error(scene, 4e-7, false));
  resume(scene);
  fly(scene);
}
