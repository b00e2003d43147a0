// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic sprocket turns under an elastic roller of another rank, by three pitches and so little
// above the teeth that all nodes of the roller are looked at. Whatever they are projected on has
// been fetched, or forces would be no numbers; and at no time more than a few gaps are.
#include "../support/tooth.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/contacts.h>

#include <deal.II/base/mpi.h>

using namespace test;

namespace
{
/// Ghosts of @p copies that are numbers.
unsigned int n_fetched(const BodyBatches &copies)
{
  const double *first = copies.position.begin() + copies.position.locally_owned_size();
  return std::count_if(first,
                       first + copies.position.get_partitioner()->n_ghost_indices(),
                       [](const double x) { return !std::isnan(x); });
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Sprocket sprocket : {Sprocket::generated, Sprocket::imported})
    {
      Tooth tooth;
      tooth.sprocket     = sprocket;
      scene::Scene scene = make_scene(tooth);
      const double outer = scene.teeth[0].outer_radius, radius = scene.teeth[0].slaves[0].radius;
      scene.bodies[0].initial.position = vector(outer + radius + 10e-6, 0.);
      scene.bodies[0].initial.velocity = Vector3();
      World              world         = make_world(scene, MPI_COMM_WORLD);
      contact::Contacts  contacts(scene, world, false);
      const Rim         &rim     = world.rims[0];
      BodyBatches       &sectors = world.copies[rim.group];
      const BodyBatches &rollers = world.copies[world.elastic_address[0].group];
      const bool         reads   = rollers.owns(0);
      const unsigned int teeth   = scene.teeth[0].teeth;
      constexpr double   dt = 20e-6, speed = 100.;
      const unsigned int n_steps = 3. * 2. * dealii::numbers::PI / teeth / (speed * dt);
      Frame             &hub     = world.frames[1];
      hub.angular_velocity       = vector(0., 0., speed);
      bool         numbers = true, touches = false;
      unsigned int most = 0;
      for (unsigned int step = 0; step < n_steps; ++step)
        {
          hub.rotation = to_matrix(rotation_about_z(speed * dt * step));
          for (unsigned int s = 0; s < sectors.n_copies(); ++s)
            if (const Frame here = rim.sector->frame(hub, s); sectors.owns(s))
              for (unsigned int node = 0; node < sectors.n_nodes(); ++node)
                NodeView(sectors.position)
                    .set(sectors.index(s, node),
                         here.position + here.rotation * Vector3(sectors.nodes.position[node]));
          world.clear_forces();
          contacts.add_forces(world, step == 0 ? 0. : dt);
          if (!reads)
            continue;
          const contact::Record &record = contacts.families()[0]->records()[0];
          numbers =
              numbers && !std::isnan(record.force.norm()) && !std::isnan(world.moment.l2_norm());
          touches = touches || record.gap < 0.;
          most    = std::max(most, n_fetched(sectors));
        }
      const auto any = [](const bool here) {
        return dealii::Utilities::MPI::max(here ? 1 : 0, MPI_COMM_WORLD) == 1;
      };
      const unsigned int in_gap =
          3 * mesh::SurfaceNodes(*sectors.part, sectors.nodes, mesh::tooth_flanks).size() *
          sectors.n_copies() / teeth;
      const bool elsewhere = any(reads && sectors.n_batches() > 0 && !sectors.owns(0)),
                 not_one = any(reads && !numbers), one_touches = any(reads && touches),
                 many = any(reads && most > 5 * in_gap), some = any(reads && most > in_gap / 2);
      if (!world.is_first_rank())
        continue;
      std::cout << (sprocket == Sprocket::generated ? "arcs\n" : "facets\n");
      verdict("sectors are another rank's", elsewhere);
      verdict("the roller stays apart", !one_touches);
      verdict("forces and moments are numbers", !not_one);
      verdict("some gap is fetched", some);
      verdict("but never more than five", !many);
    }
}
