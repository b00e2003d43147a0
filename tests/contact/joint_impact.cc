// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic ring falls on an elastic bush inside it, without damping, at eight angles. On a soft
// contact it comes back with its speed; on a stiff one part of the energy goes on as vibration. The
// balance of energies closes in both cases, with friction too. A search at every step misses
// nothing.
#include "../support/joint.h"

using namespace test;

int main()
{
  Tubes ring(tube(3.76e-3, 5.08e-3, 7e-3, {{2, 32, 4}}), mesh::roller_bore);
  Tubes bush(tube(2.6e-3, 3.715e-3, 8e-3, {{2, 40, 4}}), mesh::bush_outside_first);
  const contact::JointTables tables(ring.grid, bush.grid);

  double mass = 0.;
  for (const double m : ring.reference.mass)
    mass += m;
  const double speed = 1.;
  const double frequency =
      std::max(ring.reference.largest_frequency(), bush.reference.largest_frequency());

  struct Case
  {
    const char *name;
    double      stiffness, friction, spin;
    bool        every_step = false; // what is looked at in each step cannot be missed
  };
  for (const Case &c : {Case{"soft", 2e12, 0., 0.},
                        {"stiff", 5e14, 0., 0.},
                        {"stiff, rubbing", 5e14, 0.2, 200.},
                        {"rubbing, searched at every step", 5e14, 0.2, 200., true}})
    {
      contact::JointBatch joints(tables,
                                 {c.stiffness, 0., c.friction, 0.5 * c.stiffness, 0.},
                                 *contact::joint_kernels(element::best_kernels().width));
      const double        dt = 0.5 * 2. / frequency;
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          ring.place(lane, vector(0., 44e-6), turn_about_z(0.037 * lane));
          bush.place(lane, vector(0., 0.), turn_about_z(0.1 * lane));
          ring.batch.set(ring.batch.velocity, lane, [&](const Point<3> &, unsigned int node) {
            const Tensor<1, 3> x = ring.batch.get(ring.batch.position, node, lane);
            return vector(-c.spin * x[1], c.spin * x[0] + speed);
          });
          bush.batch.set(bush.batch.velocity, lane, [](const Point<3> &, unsigned int) {
            return Tensor<1, 3>();
          });
          joints.set_joint(lane, ring.body(lane), bush.body(lane));
        }
      const auto hold = [&](Batch &batch) { // the bush's bore
        for (unsigned int node = 0; node < bush.reference.n_nodes(); ++node)
          if (std::hypot(bush.reference.position[node][0], bush.reference.position[node][1]) <
              2.7e-3)
            for (unsigned int i = 0; i < 3; ++i)
              for (int lane = 0; lane < n_lanes; ++lane)
                batch.force[Batch::index(node, i, lane)] = 0.;
      };

      std::array<double, n_lanes> before{}, worst{};
      unsigned int                searches = 0, missed = 0;
      bool                        touched = false;
      unsigned int                after = 0, n = 0;
      for (; n < 20000 && after < 200; ++n)
        {
          if (joints.search_due(dt))
            {
              missed += joints.search(c.every_step ? 0. : 2e-6, 0.5);
              ++searches;
            }
          ring.batch.add_internal_forces();
          bush.batch.add_internal_forces();
          joints.add_forces(n > 0 ? dt : 0., dt);
          hold(bush.batch);
          ring.batch.update(dt);
          bush.batch.update(dt);
          unsigned int touching = 0;
          for (int lane = 0; lane < n_lanes; ++lane)
            {
              const double stored = joints.sums().stored[lane];
              const double total  = ring.batch.total_energy(lane) + bush.batch.total_energy(lane) +
                                   stored + joints.sums().friction_loss[lane];
              if (n == 0)
                before[lane] = total;
              worst[lane] = std::max(worst[lane], std::abs(total / before[lane] - 1.));
              touching += joints.sums().touching[lane];
            }
          touched = touched || touching > 0;
          after   = touched && touching == 0 ? after + 1 : 0;
        }

      double lowest = 1e9, highest = 0., balance = 0., loss = 0.;
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          double momentum = 0.;
          for (unsigned int node = 0; node < ring.reference.n_nodes(); ++node)
            momentum +=
                ring.reference.mass[node] * ring.batch.get(ring.batch.velocity, node, lane)[1];
          lowest  = std::min(lowest, -momentum / (mass * speed));
          highest = std::max(highest, -momentum / (mass * speed));
          balance = std::max(balance, worst[lane]);
          loss    = std::max(loss, joints.sums().friction_loss[lane] / before[lane]);
        }
      std::cout << c.name << ": restitution " << std::fixed << std::setprecision(2) << lowest
                << " to " << highest << ", friction loss over energy " << loss << std::defaultfloat
                << '\n';
      if (c.stiffness < 1e13)
        verdict("  restitution at least 0.99", lowest >= 0.99);
      verdict("  energy balance within 0.1 %", balance < 1e-3);
      if (!c.every_step)
        verdict("  searched less often than every tenth step", 10 * searches < n);
      verdict("  no contact missed", missed == 0);
    }
}
