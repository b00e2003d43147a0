// SPDX-License-Identifier: LGPL-2.1-or-later
// A sprocket's rim as copies of one sector: forces, energies and the reaction on the hub are those
// of the same mesh in one piece, randomly deformed; points between two sectors move alike to the
// last bit. A hub that turns and a rim that stands still at the start exchange their angular
// momentum and keep the sum; energy is kept to second order in the step.
#include "../support/scenes.h"

#include <chaindrive/element/hexahedra.h>
#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/mesh/sector.h>

#include <map>
#include <random>

using namespace test;

namespace
{
constexpr unsigned int teeth = 11;

/// One sprocket, placed off the origin and turned, without anything else.
scene::Scene make_scene(const scene::Mount &mount, const element::Formulation formulation)
{
  scene::Scene scene         = empty_scene();
  scene.elements.formulation = static_cast<parameters::Formulation>(formulation);
  const auto chain           = drive::make_chain(parameters::Chain());
  const auto form            = drive::make_tooth_form(teeth, chain, parameters::Sprockets(), 0);
  const auto whole           = std::make_shared<const mesh::Part>(mesh::make_sprocket(
      form, {15e-3, 0.6 * form.root_diameter, 7e-3}, scene.material.density, 1));

  scene.parts[scene::Kind::sprocket]   = whole;
  scene.sectors[scene::Kind::sprocket] = std::make_shared<const mesh::Sector>(*whole);

  scene::Body sprocket =
      body(scene::Motion::elastic, mount, 1., vector(1., 1., 6e-5), vector(0., 0.));
  sprocket.kind             = scene::Kind::sprocket;
  sprocket.initial.rotation = to_matrix(rotation_about_z(0.3));
  scene.bodies              = {sprocket};
  return scene;
}

/// Forces [N] of the whole mesh at once on each of its vertices, and its energies [J].
struct Whole
{
  std::vector<Vector3> force;
  std::vector<double>  mass;
  double               strain = 0., hourglass = 0., largest_frequency = 0.;
};

Whole whole_mesh(const scene::Scene         &scene,
                 const element::Formulation  formulation,
                 const std::vector<Vector3> &position)
{
  const mesh::Part        &part = *scene.parts.at(scene::Kind::sprocket);
  const mesh::Nodes        nodes(part);
  const element::Hexahedra reference(part, nodes, scene.material, formulation);
  const auto               index = [](const unsigned int node, const unsigned int d) {
    return (3 * node + d) * n_lanes;
  };
  dealii::AlignedVector<double> x(index(nodes.size(), 0), 0.), f(x.size(), 0.), energy(16, 0.);
  for (unsigned int n = 0; n < nodes.size(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        x[index(n, d) + lane] = position[nodes.vertex[n]][d];

  element::ForceArguments arg = reference.arguments();
  arg.position                = x.data();
  arg.force                   = f.data();
  arg.strain_energy           = energy.data();
  arg.hourglass_energy        = energy.data() + n_lanes;
  element::best_kernels().add_internal_forces[static_cast<int>(formulation)](arg);

  Whole whole;
  whole.force.resize(position.size());
  whole.mass.resize(position.size());
  for (unsigned int n = 0; n < nodes.size(); ++n)
    {
      whole.mass[nodes.vertex[n]] = nodes.mass[n];
      for (unsigned int d = 0; d < 3; ++d)
        whole.force[nodes.vertex[n]][d] = f[index(n, d)];
    }
  whole.strain            = energy[0];
  whole.hourglass         = energy[n_lanes];
  whole.largest_frequency = reference.largest_frequency();
  return whole;
}

void compare_forces(const std::string &name, const element::Formulation formulation)
{
  const scene::Scene scene = make_scene(scene::Mount::motor(), formulation);
  dynamics::System   system(scene, false);
  World             &world   = system.world;
  NodalGroup        &sectors = *world.groups.nodal().back();
  const ForceTimer   timer{system.timer, PhaseTimer::rest};
  const Rim         &rim    = world.rims[0];
  BodyBatches       &copies = world.copies[rim.group];
  const Frame       &hub    = world.frames[0];

  // 20 um at random: strains of some per cent, in which the round-off of positions is lost
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> within(-20e-6, 20e-6);
  std::vector<Vector3>                   position;
  for (const dealii::Point<3> &vertex : scene.parts.at(scene::Kind::sprocket)->mesh->get_vertices())
    position.push_back(hub.position + hub.rotation * Vector3(vertex) +
                       vector(within(random), within(random), within(random)));
  const auto vertex_of = [&](const unsigned int s, const unsigned int node) {
    return rim.sector->whole_vertex[s][copies.nodes.vertex[node]];
  };
  for (unsigned int s = 0; s < teeth; ++s)
    for (unsigned int n = 0; n < copies.n_nodes(); ++n)
      for (unsigned int d = 0; d < 3; ++d)
        NodeView(copies.position).component(copies.index(s, n), d) = position[vertex_of(s, n)][d];
  const Whole whole = whole_mesh(scene, formulation, position);

  world.clear_forces();
  world.groups.force().back()->add_forces(world, timer);
  sectors.advance(world, {0., 0., 9.81, 0., nullptr, false}, timer);
  Vector3 reaction, moment;
  double  sum = 0.; // of forces on the hub
  for (const unsigned int n : rim.border)
    for (unsigned int s = 0; s < teeth; ++s)
      {
        // a vertex between two sectors is visited twice
        double visits = 0.;
        for (unsigned int other = 0; other < teeth; ++other)
          for (const unsigned int m : rim.border)
            visits += vertex_of(other, m) == vertex_of(s, n) ? 1. : 0.;
        const unsigned int v = vertex_of(s, n);
        reaction += whole.force[v] / visits;
        sum += whole.force[v].norm() / visits;
        moment += cross_product_3d(position[v] - hub.position, whole.force[v]) / visits;
      }
  Vector3 reaction_here, moment_here;
  for (unsigned int d = 0; d < 3; ++d)
    {
      reaction_here[d] = world.force.local_element(d);
      moment_here[d]   = world.moment.local_element(d);
    }

  // from rest, half a kick
  const double dt = 1e-8;
  sectors.start(world, {dt, dt, 0., 0., {}}, timer);
  double error = 0., largest = 0.;
  bool   alike = true;
  for (unsigned int s = 0; s < teeth; ++s)
    for (unsigned int n = 0; n < copies.n_nodes(); ++n)
      {
        const unsigned int v    = vertex_of(s, n);
        const bool         held = std::binary_search(rim.border.begin(), rim.border.end(), n);
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double speed    = NodeView(copies.velocity).component(copies.index(s, n), d);
            const double expected = held ? 0. : 0.5 * dt * whole.force[v][d] / whole.mass[v];
            error                 = std::max(error, std::abs(speed - expected));
            largest               = std::max(largest, std::abs(expected));
          }
      }
  for (const auto &[v, w] : rim.sector->seam)
    for (unsigned int s = 0; s < teeth; ++s)
      for (unsigned int d = 0; d < 3; ++d)
        {
          const auto i = copies.index(s, copies.nodes.of_vertex[v]) + component_offset(d);
          const auto j =
              copies.index((s + 1) % teeth, copies.nodes.of_vertex[w]) + component_offset(d);
          alike = alike && copies.velocity.local_element(i) == copies.velocity.local_element(j) &&
                  copies.position.local_element(i) == copies.position.local_element(j);
        }

  std::cout << name << ", " << rim.sector->seam.size() << " of " << copies.n_nodes()
            << " nodes of a sector meet one of the next, " << rim.border.size() << " the hub\n";
  verdict("  accelerations are those of the whole mesh to 1e-12", error < 1e-12 * largest);
  verdict("  points between sectors move alike to the last bit", alike);
  verdict("  force and moment on the hub to 1e-12",
          (reaction_here - reaction).norm() < 1e-12 * sum &&
              (moment_here - moment).norm() < 1e-12 * sum * 15e-3);
  verdict("  energies to 1e-12",
          std::abs(world.ledger.strain - whole.strain) < 1e-12 * whole.strain &&
              std::abs(world.ledger.hourglass - whole.hourglass) <= 1e-12 * whole.strain);
  std::cout << "  critical time step of a sector alone over that of the whole: " << std::fixed
            << std::setprecision(3) << sectors.critical_time_step() / (2. / whole.largest_frequency)
            << std::defaultfloat << '\n';
}

/// A hub at 100 rad/s, a rim at rest. Returns the largest imbalance over the energy at the start.
double serialize(const double dt)
{
  const scene::Scene scene = make_scene(scene::Mount::revolute(), element::Formulation::enhanced);
  dynamics::System   system(scene, false);
  World             &world  = system.world;
  const BodyBatches &copies = world.copies[0];
  World::Hub        &hub    = world.hubs[0];
  hub.speed                 = 100.;
  world.ledger.initial      = 0.5 * hub.inertia * hub.speed * hub.speed;
  const double momentum     = hub.inertia * hub.speed;
  double       worst = 0., drift = 0., slowest = hub.speed;
  advance(system, static_cast<unsigned long>(std::lround(60e-6 / dt)), dt, [&]() {
    // all at n + 1/2; see dynamics/elastic_free
    double sum = hub.inertia * hub.speed + 0.5 * dt * world.moment.local_element(2);
    for (unsigned int s = 0; s < teeth; ++s)
      for (unsigned int n = 0; n < copies.n_nodes(); ++n)
        {
          const Vector3 x = copies.position_now(s, n) - world.frames[0].position;
          const double  u = NodeView(copies.velocity).component(copies.index(s, n), 0),
                       v  = NodeView(copies.velocity).component(copies.index(s, n), 1);
          sum += copies.nodes.mass[n] * (x[0] * v - x[1] * u);
        }
    drift   = std::max(drift, std::abs(sum - momentum));
    worst   = std::max(worst, std::abs(world.ledger.imbalance()));
    slowest = std::min(slowest, hub.speed);
  });
  if (dt > 4e-8)
    {
      verdict("the rim takes up motion from the hub", slowest < 0.9 * 100.);
      verdict("and angular momentum is kept to 1e-11", drift < 1e-11 * momentum);
    }
  return worst / world.ledger.initial;
}
} // namespace

int main()
{
  compare_forces("one point", element::Formulation::one_point);
  compare_forces("enhanced", element::Formulation::enhanced);
  compare_forces("full", element::Formulation::full);
  const double coarse = serialize(6e-8), fine = serialize(3e-8);
  verdict("energy is kept to 1e-3", coarse < 1e-3);
  std::cout << "order of the imbalance in the step: " << std::fixed << std::setprecision(1)
            << std::log2(coarse / fine) << '\n';
}
