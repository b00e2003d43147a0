// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic bodies, on one rank and on two, with one thing wrong at a node: the drive must be stopped
// within 100 steps, with the same words on all ranks, and they must name the body.
#include "../support/faults.h"
#include "../support/small_drive.h"

#include <limits>

using namespace test;

namespace
{
/// Adds @p force to a node of an elastic body, on the rank that owns it.
void push_node(System            &system,
               const unsigned int body,
               const unsigned int node,
               const Vector3     &force)
{
  const World::Address &place  = system.world.elastic_address[body];
  BodyBatches          &copies = system.world.copies[place.group];
  if (!copies.owns(place.copy))
    return;
  NodeView(copies.force).add(copies.index(place.copy, node), force);
}

Vector3 along_x(const double size)
{
  Vector3 v;
  v[0] = size;
  return v;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const scene::Scene                             scene =
      drive_scene("prm/paper/layered-auto.prm",
                  small_full_drive_with({"Loads/Ramp time in ms=0.002", "Mesh/Refinement=0"}));
  const auto         sound      = [&scene]() { return Drive(scene, 200, 0.9, MPI_COMM_WORLD); };
  const unsigned int first_link = scene.drive.n_joints; // bodies: rollers, then links

  // 1 kN, as in the tight span
  sound().expect_stop("a force on a roller without its reaction",
                      {"Momentum", "Where: roller 4: its momentum changes by", "of roller 4"},
                      {},
                      [](System &s) { push_node(s, 4, 0, along_x(1e3)); });
  sound().expect_stop("a force on a link without its reaction",
                      {"Momentum", "Where: outer link 7: its momentum changes by"},
                      {},
                      [&](System &s) { push_node(s, first_link + 7, 5, along_x(1e3)); });
  sound().expect_stop("opposite forces where there are none",
                      {"nergy", "outer link 7", "inner link 8"},
                      {},
                      [&](System &s) {
                        push_node(s, first_link + 7, 5, along_x(1e3));
                        push_node(s, first_link + 8, 5, along_x(-1e3));
                      });
  Drive(scene, 0, 1.3, MPI_COMM_WORLD)
      .expect_stop("step 1.3 times the limit",
                   {"nergy", "Most often the step is too large", "Where: node"},
                   {});

  for (const unsigned int body : {0U, 5U, 13U, first_link + 3, first_link + 16})
    {
      Drive                 drive  = sound();
      const World::Address &place  = drive.system.world.elastic_address[body];
      BodyBatches          &copies = drive.system.world.copies[place.group];
      if (copies.owns(place.copy))
        NodeView(copies.velocity).component(copies.index(place.copy, 12), 1) =
            std::numeric_limits<double>::quiet_NaN();
      drive.expect_stop("one lane is not a number, body " + std::to_string(body),
                        {"not a number",
                         "Where: node 12 of " +
                             std::string(body < first_link            ? "roller" :
                                         (body - first_link) % 2 == 0 ? "inner link" :
                                                                        "outer link") +
                             " " + std::to_string(scene.bodies[body].number)},
                        {});
    }

  Drive last = sound(); // only one rank sees it
  last.expect_stop("an alarm of the last rank", {"run through each other"}, {}, [](System &s) {
    const World &world = s.world;
    if (rank_in(world.communicator()) + 1 == n_ranks_in(world.communicator()))
      s.requests.ask(dynamics::Request::alarm);
  });
}
