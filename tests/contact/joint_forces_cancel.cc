// SPDX-License-Identifier: LGPL-2.1-or-later
// What a joint does to one body it undoes to the other: forces cancel to round-off, and so do
// moments without friction; with it they do but for a ten-thousandth of friction times sagitta,
// because a deformed bore is twisted. Bodies deformed, tilted and turned, far from the origin.
#include "../support/joint.h"

using namespace test;

int main()
{
  const unsigned int columns = 32;
  Tubes              ring(tube(3.76e-3, 5.08e-3, 7e-3, {{1, columns, 3}}), mesh::roller_bore);
  Tubes              bush(tube(2.6e-3, 3.715e-3, 8e-3, {{1, 40, 4}}), mesh::bush_outside_first);
  const contact::JointTables tables(ring.grid, bush.grid);

  for (const double friction : {0., 0.2})
    {
      contact::JointBatch joints(
          tables, {4e13, 0., friction, 3e13, 0.}, *contact::joint_kernels(2));
      std::mt19937                           random(3);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      ring.batch.force.fill(0.);
      bush.batch.force.fill(0.);
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          const Tensor<2, 3> turned = turn(0.7 * lane);
          const Tensor<1, 3> at     = vector(0.1, 0.2, 0.3) * uniform(random);
          ring.place(lane, at, turned * turn_about_z(uniform(random)));
          bush.place(lane,
                     at + turned * vector(4.6e-5 * std::cos(lane), 4.6e-5 * std::sin(lane)),
                     turned * turn_about_z(3. * uniform(random)));
          for (Tubes *tubes : {&ring, &bush})
            {
              for (unsigned int node = 0; node < tubes->reference.n_nodes(); ++node)
                for (int i = 0; i < 3; ++i)
                  {
                    const unsigned int at_node = Batch::index(node, i, lane);
                    tubes->batch.position[at_node] += 5e-7 * uniform(random);
                    tubes->batch.velocity[at_node] = uniform(random);
                  }
              joints.set_joint(lane, ring.body(lane), bush.body(lane));
            }
        }
      joints.search(1e-6, 1.);
      joints.add_forces(1e-6, 1e-6);

      double forces = 0., moments = 0., reported = 0.;
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          Tensor<1, 3> sum, turning, on_slave;
          double       scale = 0.;
          for (Tubes *tubes : {&ring, &bush})
            for (unsigned int node = 0; node < tubes->reference.n_nodes(); ++node)
              {
                const Tensor<1, 3> f = tubes->batch.get(tubes->batch.force, node, lane);
                sum += f;
                turning += cross_product_3d(tubes->batch.get(tubes->batch.position, node, lane), f);
                scale += 0.5 * f.norm();
                if (tubes == &bush)
                  on_slave += f;
              }
          for (int i = 0; i < 3; ++i)
            reported =
                std::max(reported, std::abs(on_slave[i] - joints.sums().force[i][lane]) / scale);
          forces  = std::max(forces, sum.norm() / scale);
          moments = std::max(moments, turning.norm() / (scale * 3.76e-3));
        }
      std::cout << "friction " << friction << '\n';
      verdict("  forces cancel to 1e-13 of their sum", forces < 1e-13);
      verdict("  the sums report the force on the slave", reported < 1e-13);
      if (friction == 0.)
        verdict("  moments cancel to 1e-12 of force times radius", moments < 1e-12);
      else
        verdict("  moments cancel to 1e-6 of force times radius", moments < 1e-6);
    }
}
