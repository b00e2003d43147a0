// SPDX-License-Identifier: LGPL-2.1-or-later
// Reduced rollers and the reduced links on whose bushes they are collide, spinning and with
// friction, in two batches: on two ranks joints reach from one rank to the other. Momentum of
// each pair stays, and its moment but for what friction in a twisted bore makes of it
// (contact/joint_forces_cancel). The balance of energies closes, without friction and damping with
// an order of the step between the first and the second: nodes touch and part. The same on any
// number of ranks. Nodes that nobody reads are not placed: the same motion with a search at every
// step, which reads them all.
#include "../support/reduced.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>

#include <deal.II/base/mpi.h>

using namespace test;

namespace
{
constexpr unsigned int n = 11;

scene::Scene make_scene(const bool rubs)
{
  scene::Scene scene               = empty_scene();
  const auto   chain               = drive::make_chain(parameters::Chain());
  scene.parts[scene::Kind::roller] = std::make_shared<const mesh::Part>(
      mesh::make_roller(chain, scene.material.density, mesh::RollerGrid(2, 24, 4)));
  scene.parts[scene::Kind::inner_link] = std::make_shared<const mesh::Part>(
      mesh::make_inner_link(chain, scene.material.density, mesh::inner_link_grid(0)));

  // roller k is on the first bush of link k + 1: some pairs lie in different batches
  const Vector3 arm = vector(-0.5 * chain.inner_hole_pitch, 0.);
  for (unsigned int k = 0; k < n; ++k)
    {
      scene::Body link      = body(scene::Motion::elastic,
                              scene::Mount::free(),
                              0.,
                              Vector3(),
                              vector(0.05 * k, 0.01 * k),
                              vector(0.3, 0.1 * k, 0.));
      link.kind             = scene::Kind::inner_link;
      link.initial.rotation = to_matrix(rotation_about_z(0.4 * k));
      scene.bodies.push_back(link);
    }
  scene::BoreFamily joint;
  joint.name    = "roller-bush";
  joint.elastic = true;
  joint.law     = {1e14, 0., 0., 0., 0.};
  if (rubs)
    joint.law = {1e14, 4e6, 0.3, 8e13, 4e6};
  for (unsigned int k = 0; k < n; ++k)
    {
      const unsigned int on           = (k + 1) % n;
      const Frame       &link         = scene.bodies[on].initial;
      scene::Body        roller       = body(scene::Motion::elastic,
                                scene::Mount::free(),
                                0.,
                                Vector3(),
                                link.position + link.rotation * arm + vector(2e-5, 1e-5),
                                link.velocity + vector(1., 0.3 * k - 1., 0.));
      roller.initial.rotation         = to_matrix(rotation_about_z(0.1 * k));
      roller.initial.angular_velocity = vector(0., 0., rubs ? 400. : 0.);
      scene.bodies.push_back(roller);
      joint.pairs.push_back({n + k,
                             dealii::Point<3>(),
                             0.5 * chain.roller_bore,
                             {on, dealii::Point<3>(arm), 0.5 * chain.bush_diameter, k},
                             mesh::roller_bore,
                             mesh::bush_outside_first});
    }
  scene.bores.push_back(joint);
  reduce(scene);
  return scene;
}

/// Of roller @p k and its link.
struct Momentum
{
  Vector3 linear, angular;
};

Momentum momentum(const World &world, const unsigned int k)
{
  Momentum sum;
  for (const unsigned int b : {n + k, (k + 1) % n})
    {
      const Vector3 p = world.mass[b] * world.frames[b].velocity;
      sum.linear += p;
      sum.angular += cross_product_3d(world.frames[b].position, p) + world.rotations[b].momentum;
    }
  return sum;
}

struct Outcome
{
  double        linear = 0., angular = 0., imbalance = 0., friction = 0., turned = 0., ringing = 0.;
  unsigned long missed = 0;
  std::vector<Vector3> velocity; ///< of all bodies
};

Outcome
collide(const bool rubs, const double dt, const MPI_Comm comm, const bool search_every_step = false)
{
  dynamics::System      system(make_scene(rubs), search_every_step, comm);
  const World          &world = system.world;
  std::vector<Momentum> start;
  for (unsigned int k = 0; k < n; ++k)
    start.push_back(momentum(world, k));
  Outcome outcome;
  advance(system, static_cast<unsigned long>(std::lround(1.5e-4 / dt)), dt, [&]() {
    outcome.imbalance = std::max(outcome.imbalance, std::abs(world.ledger.imbalance()));
  });
  for (unsigned int k = 0; k < n; ++k)
    {
      const Momentum now = momentum(world, k);
      outcome.linear =
          std::max(outcome.linear, (now.linear - start[k].linear).norm() / start[k].linear.norm());
      outcome.angular = std::max(outcome.angular,
                                 (now.angular - start[k].angular).norm() / start[k].angular.norm());
      outcome.turned =
          std::max(outcome.turned, std::abs(world.frames[(k + 1) % n].angular_velocity[2]));
    }
  for (const Frame &frame : world.frames)
    outcome.velocity.push_back(frame.velocity);
  outcome.imbalance /= world.ledger.initial;
  outcome.friction = world.ledger.friction / world.ledger.initial;
  outcome.ringing  = world.ledger.strain / world.ledger.initial;
  outcome.missed   = dealii::Utilities::MPI::sum(system.contacts.n_missed(), comm);
  return outcome;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool    first  = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const double  dt     = 2e-7;
  const Outcome rubbed = collide(true, dt, MPI_COMM_WORLD),
                coarse = collide(false, dt, MPI_COMM_WORLD),
                fine   = collide(false, 0.25 * dt, MPI_COMM_WORLD),
                always = collide(true, dt, MPI_COMM_WORLD, true);
  if (!first)
    return 0;
  verdict("momentum kept to 1e-10", rubbed.linear < 1e-10);
  verdict("angular momentum to 1e-10, with friction to 1e-7",
          coarse.angular < 1e-10 && rubbed.angular < 1e-7);
  std::cout << std::fixed << std::setprecision(3) << "fastest link turns with " << rubbed.turned
            << " rad/s; friction took " << 100. * rubbed.friction << " % of the energy, "
            << 100. * rubbed.ringing << " % are strain\n";
  verdict("imbalance below 1e-3 of the energy", rubbed.imbalance < 1e-3 && coarse.imbalance < 1e-3);
  std::cout << std::defaultfloat;
  verdict("and more than 6 times smaller at a quarter of the step",
          coarse.imbalance > 6. * fine.imbalance);
  verdict("no contact missed", rubbed.missed + coarse.missed + fine.missed == 0);
  double difference = 0.;
  for (unsigned int b = 0; b < always.velocity.size(); ++b)
    difference = std::max(difference, (always.velocity[b] - rubbed.velocity[b]).norm());
  verdict("the same as with a search at every step to 1e-8 m/s", difference < 1e-8);
}
