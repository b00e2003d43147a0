// SPDX-License-Identifier: LGPL-2.1-or-later
// The law of nodes in packs is that of points one by one; every width of the joint kernels gives
// what the scalar ones give, each lane with its own bodies, wherever these sit in their batches.
#include "../support/joint.h"

#include <chaindrive/contact/point_force.h>

using namespace test;

namespace
{
/// A random history of two contact points, with the scalar and with the packed law.
double difference_of_laws(const double friction)
{
  using P = Pack<double, 2>;
  const scene::ContactLaw law{3e7, 40., friction, 2e7, 30.};

  std::mt19937                           random(5);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  contact::TouchState                    scalar[2];
  Ledger                                 ledger[2];
  contact::TouchStateOf<P>               packed{0., 0., {0., 0.}, {0., 0.}};
  contact::ContactEnergies<P>            energies{0., 0., 0.};
  double                                 difference = 0.;
  for (unsigned int n = 0; n < 2000; ++n)
    {
      P gap(0.), gap_rate(0.), slip_rate[2] = {0., 0.};
      energies.stored = P(0.);
      for (int i = 0; i < 2; ++i)
        {
          gap.v[i]      = 1e-6 * (std::sin(0.05 * n + i) + 0.2 * uniform(random) - 0.3);
          gap_rate.v[i] = 0.5 * uniform(random);
          for (int d = 0; d < 2; ++d)
            slip_rate[d].v[i] = 3. * std::sin(0.03 * n + d) + 2. * uniform(random);
          Tensor<1, 2> rate;
          rate[0] = slip_rate[0][i];
          rate[1] = slip_rate[1][i];
          ledger[i].clear_stored();
          contact::update_point(law, gap[i], gap_rate[i], rate, 1e-7, scalar[i], ledger[i]);
        }
      const P penetration = greatest(P(0.), P(0.) - gap);
      const P closing     = if_less(P(0.), // as a point by itself has it when it meets the surface
                                packed.penetration,
                                penetration - packed.penetration,
                                P(0.) - gap_rate * P(1e-7));
      contact::update_touch(scene::ContactLawOf<P>{law.stiffness,
                                                   law.damping,
                                                   friction,
                                                   law.tangential_stiffness,
                                                   law.tangential_damping},
                            contact::NodeApproach<P>{penetration, gap, gap_rate, closing},
                            slip_rate,
                            P(1e-7),
                            friction > 0.,
                            packed,
                            energies);
      for (int i = 0; i < 2; ++i)
        for (const double d : {(packed.normal[i] - scalar[i].normal) / 50.,
                               (packed.tangential[0][i] - scalar[i].tangential[0]) / 50.,
                               (packed.tangential[1][i] - scalar[i].tangential[1]) / 50.,
                               (packed.slip[0][i] - scalar[i].slip[0]) / 1e-6,
                               (packed.slip[1][i] - scalar[i].slip[1]) / 1e-6,
                               (packed.penetration[i] - scalar[i].penetration) / 1e-6,
                               (energies.stored[i] - ledger[i].contact) / 5e-5,
                               (energies.damping_loss[i] - ledger[i].contact_damping) / 5e-5,
                               (energies.friction_loss[i] - ledger[i].friction) / 5e-5})
          difference = std::max(difference, std::abs(d));
    }
  return difference;
}

/// Seven joints of eight rings and bushes in other lanes, a lane empty, some steps. Bushes are
/// turned by @p tilt [rad] in their rings.
struct Case
{
  Case(const mesh::Part &ring_part, const mesh::Part &bush_part, const int width, const double tilt)
      : ring(ring_part, mesh::roller_bore)
      , bush(bush_part, mesh::bush_outside_first)
      , tables(ring.grid, bush.grid)
      , joints(tables, {4e13, 2e6, 0.2, 3e13, 2e6}, *contact::joint_kernels(width))
  {
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    for (int lane = 0; lane < n_lanes; ++lane)
      {
        const int          other  = (3 * lane + 1) % n_lanes;
        const Tensor<2, 3> turned = turn(0.7 * lane);
        const Tensor<1, 3> at     = vector(0.1, 0.2, 0.3) * uniform(random);
        ring.place(lane, at, turned * turn_about_z(uniform(random)));
        bush.place(other,
                   at + turned * vector(4.6e-5 * std::cos(lane), 4.6e-5 * std::sin(lane)),
                   turned * turn(tilt) * turn_about_z(3. * uniform(random)));
        for (Tubes *tubes : {&ring, &bush})
          tubes->batch.set(tubes->batch.velocity,
                           tubes == &ring ? lane : other,
                           [&](const Point<3> &, unsigned int) {
                             const double z = uniform(random), y = uniform(random),
                                          x = uniform(random);
                             return vector(x, y, z);
                           });
        if (lane != 5)
          joints.set_joint(lane, ring.body(lane), bush.body(other));
      }
    for (unsigned int n = 0; n < 5; ++n)
      {
        joints.search(1e-6, 1.);
        joints.add_forces(1e-7, 1e-7);
        for (Tubes *tubes : {&ring, &bush})
          for (unsigned int i = 0; i < tubes->batch.position.size(); ++i)
            tubes->batch.position[i] += 1e-7 * tubes->batch.velocity[i];
      }
  }

  Tubes                ring, bush;
  contact::JointTables tables;
  contact::JointBatch  joints;
};

/// Whether all widths give the same.
void compare_widths(const double bush_length, const double tilt)
{
  const mesh::Part ring = tube(3.76e-3, 5.08e-3, 7e-3, {{1, 24, 3}}),
                   bush = tube(2.6e-3, 3.715e-3, bush_length, {{1, 32, 4}});
  const Case   scalar(ring, bush, 1, tilt);
  unsigned int touching = 0;
  double       largest  = 0.;
  for (int lane = 0; lane < n_lanes; ++lane)
    touching += scalar.joints.sums().touching[lane];
  for (const double f : scalar.bush.batch.force)
    largest = std::max(largest, std::abs(f));
  std::cout << touching << " nodes touch, " << scalar.joints.n_visited() << " are visited\n";

  for (const int width : {2, 4, 8})
    {
      double difference = 0.;
      if (contact::joint_kernels(width) != nullptr) // else nothing to compare
        {
          const Case packed(ring, bush, width, tilt);
          const auto compare = [&](const double a, const double b, const double scale) {
            difference = std::max(difference, std::abs(a - b) / scale);
          };
          for (unsigned int i = 0; i < packed.ring.batch.force.size(); ++i)
            compare(packed.ring.batch.force[i], scalar.ring.batch.force[i], largest);
          for (unsigned int i = 0; i < packed.bush.batch.force.size(); ++i)
            compare(packed.bush.batch.force[i], scalar.bush.batch.force[i], largest);
          const contact::JointSums &a = packed.joints.sums(), &b = scalar.joints.sums();
          for (int lane = 0; lane < n_lanes; ++lane)
            {
              compare(a.stored[lane], b.stored[lane], 1e-6 * largest);
              compare(a.damping_loss[lane], b.damping_loss[lane], 1e-6 * largest);
              compare(a.friction_loss[lane], b.friction_loss[lane], 1e-6 * largest);
              compare(a.largest_penetration[lane], b.largest_penetration[lane], 1e-6);
              compare(a.touching[lane], b.touching[lane], 1.);
              compare(packed.joints.window().first[lane], scalar.joints.window().first[lane], 1.);
              compare(packed.joints.window().count[lane], scalar.joints.window().count[lane], 1.);
              for (int i = 0; i < 3; ++i)
                compare(a.force[i][lane], b.force[i][lane], largest);
            }
        }
      std::cout << "width " << width;
      verdict(": as scalar to 1e-11", difference < 1e-11);
    }
}
} // namespace

int main()
{
  verdict("law with friction as scalar to 1e-12", difference_of_laws(0.15) < 1e-12);
  verdict("law without friction as scalar to 1e-12", difference_of_laws(0.) < 1e-12);

  compare_widths(8e-3, 0.);
  std::cout
      << "tilted, as long as the ring: columns side by side are just inside and just outside\n";
  compare_widths(7e-3, 1e-3);
}
