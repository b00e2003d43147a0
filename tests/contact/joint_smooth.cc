// SPDX-License-Identifier: LGPL-2.1-or-later
// A bush pressed into a bore by a given overlap, 32 columns on both sides: the force does not
// change as the bore turns about the bush, by less than 1 % as the bush turns in the bore, and by
// less than 1 % as the bush rolls along the bore. It points to the bore's axis.
#include "../support/joint.h"

using namespace test;

namespace
{
struct Range
{
  void add(const double x)
  {
    low  = std::min(low, x);
    high = std::max(high, x);
  }
  double ripple() const { return (high - low) / (0.5 * (high + low)); }

  double low = 1e99, high = -1e99;
};
} // namespace

int main()
{
  const double bore = 3.76e-3, outside = 3.715e-3;
  Tubes        ring(tube(bore, 5.08e-3, 7e-3, {{1, 32, 3}}), mesh::roller_bore);
  Tubes        bush(tube(2.6e-3, outside, 8e-3, {{1, 32, 4}}), mesh::bush_outside_first);
  const contact::JointTables tables(ring.grid, bush.grid);

  for (const double penetration : {1e-6, 2e-6, 5e-6})
    {
      contact::JointBatch joints(tables, {1e14, 0., 0., 0., 0.}, *contact::joint_kernels(8));
      const double        eccentricity = bore - outside + penetration;
      Range               ring_turns[n_lanes], bush_turns[n_lanes], rolls[n_lanes];
      double              sideways = 0.;
      const auto          press    = [&](const double at,
                             const double ring_angle,
                             const double bush_angle,
                             Range *const range,
                             const double step) {
        for (int lane = 0; lane < n_lanes; ++lane)
          {
            const double phase = 0.03 * lane;
            ring.place(lane, vector(0.1, 0.2), turn_about_z(phase + ring_angle));
            bush.place(lane,
                       vector(0.1 + eccentricity * std::cos(at), 0.2 + eccentricity * std::sin(at)),
                       turn_about_z(2. * phase + bush_angle));
            joints.set_joint(lane, ring.body(lane), bush.body(lane));
          }
        joints.search(1e-6, 1.);
        joints.add_forces(step, step);
        for (int lane = 0; lane < n_lanes; ++lane)
          {
            const double fx = joints.sums().force[0][lane], fy = joints.sums().force[1][lane];
            const double along = -fx * std::cos(at) - fy * std::sin(at);
            range[lane].add(along);
            sideways = std::max(sideways, std::abs(fx * std::sin(at) - fy * std::cos(at)) / along);
          }
      };
      const unsigned int steps = 60;
      for (unsigned int i = 0; i < steps; ++i)
        {
          const double angle = 2. * PI / 32. * i / steps;
          press(0., angle, 0., ring_turns, 0.);
          press(0., 0., angle, bush_turns, 0.);
          // rolling: the centre goes one way, the bush turns the other way
          press(angle, 0., -angle * (bore - outside) / outside, rolls, 0.);
        }
      double largest[3] = {0., 0., 0.};
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          largest[0] = std::max(largest[0], ring_turns[lane].ripple());
          largest[1] = std::max(largest[1], bush_turns[lane].ripple());
          largest[2] = std::max(largest[2], rolls[lane].ripple());
        }
      std::cout << "overlap " << 1e6 * penetration << " um: half of the angle of contact "
                << std::setprecision(3) << 180. / PI * std::acos((bore - outside) / eccentricity)
                << " degrees\n";
      verdict("  bore turns: ripple below 1e-9", largest[0] < 1e-9);
      verdict("  bush turns: ripple below 1 %", largest[1] < 0.01);
      verdict("  bush rolls: ripple below 1 %", largest[2] < 0.01);
      verdict("  force points to the axis to 1 %", sideways < 0.01);
    }
}
