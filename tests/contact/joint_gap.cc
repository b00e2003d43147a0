// SPDX-License-Identifier: LGPL-2.1-or-later
// A node's distance from an undeformed bore is exact to a picometre wherever the bodies stand,
// whatever the meshes: R less the distance from the bore's axis. A deformed bore has no steps: over
// ever smaller turns, the change of a gap becomes ever smaller.
#include "../support/joint.h"

using namespace test;

int main()
{
  const double bore = 3.76e-3, outside = 3.715e-3;
  for (const unsigned int columns : {24u, 32u, 50u})
    {
      const mesh::Part ring_part = tube(bore, 5.08e-3, 7e-3, {{1, 32, 4}}),
                       bush_part = tube(2.6e-3, outside, 8e-3, {{1, columns, 6}});
      Tubes ring(ring_part, mesh::roller_bore);
      Tubes bush(bush_part, mesh::bush_outside_first);

      const contact::JointTables             tables(ring.grid, bush.grid);
      contact::JointBatch                    joints(tables, {}, *contact::joint_kernels(8));
      std::mt19937                           random(1);
      std::uniform_real_distribution<double> uniform(-1., 1.);

      double error = 0.;
      for (unsigned int repetition = 0; repetition < 20; ++repetition)
        {
          std::array<Tensor<1, 3>, n_lanes> origin, axis;
          for (int lane = 0; lane < n_lanes; ++lane)
            {
              // both anywhere, and the bush tilted in the ring as far as the clearance goes
              const Tensor<2, 3> turned = turn(3. * uniform(random));
              origin[lane]              = vector(0.3, 0.2, -0.1) * uniform(random);
              axis[lane]                = turned * vector(0., 0., 1.);
              ring.place(lane, origin[lane], turned * turn_about_z(4. * uniform(random)));
              Tensor<2, 3> tilt;
              tilt[0][0] = tilt[2][2] = std::cos(0.01);
              tilt[1][1]              = 1.;
              tilt[0][2]              = std::sin(0.01);
              tilt[2][0]              = -tilt[0][2];
              bush.place(lane,
                         origin[lane] +
                             turned * vector(4e-5 * uniform(random), 4e-5 * uniform(random), 5e-4),
                         turned * tilt * turn_about_z(4. * uniform(random)));
              joints.set_joint(lane, ring.body(lane), bush.body(lane));
            }
          const auto &gap = joints.measure_gaps();
          for (int lane = 0; lane < n_lanes; ++lane)
            for (unsigned int s = 0; s < bush.grid.n_rings(); ++s)
              for (unsigned int c = 0; c < columns; ++c)
                {
                  Tensor<1, 3> x =
                      bush.batch.get(bush.batch.position, bush.node(s, c), lane) - origin[lane];
                  x -= (x * axis[lane]) * axis[lane];
                  error = std::max(
                      error, std::abs(gap[(s * columns + c) * n_lanes + lane] - (bore - x.norm())));
                }
        }
      std::cout << columns << " columns in 32: ";
      verdict("gap exact to 1e-6 um", error < 1e-12);

      // a bore with waves of a micrometre from node to node; the bush turns by two of its cells
      std::vector<double> largest;
      for (const unsigned int steps : {1000u, 2000u, 4000u})
        {
          double              change = 0.;
          std::vector<double> last;
          for (unsigned int i = 0; i <= steps; ++i)
            {
              for (int lane = 0; lane < n_lanes; ++lane)
                {
                  ring.place(lane, Tensor<1, 3>(), turn_about_z(0.1 * lane));
                  ring.batch.set(ring.batch.position, lane, [&](const Point<3> &x, unsigned node) {
                    const double wave = 1e-6 * std::sin(1. + 7. * node) / bore;
                    return Tensor<1, 3>(vector(x[0] * (1. + wave), x[1] * (1. + wave), x[2]));
                  });
                  bush.place(lane,
                             vector(2e-5, -1e-5, 3.6e-3),
                             turn_about_z(0.3 * lane + 0.4 * i / steps));
                }
              const auto &gap = joints.measure_gaps();
              for (unsigned int k = 0; k < gap.size() && i > 0; ++k)
                change = std::max(change, std::abs(gap[k] - last[k]));
              last.assign(gap.begin(), gap.end());
            }
          largest.push_back(change);
        }
      std::cout << columns
                << " columns in 32: largest change of a gap over a step, halved with it: "
                << std::fixed << std::setprecision(3) << largest[1] / largest[0] << ' '
                << largest[2] / largest[1] << std::defaultfloat << '\n';
    }
}
