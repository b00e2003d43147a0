// SPDX-License-Identifier: LGPL-2.1-or-later
// Random forces at random points and their mirror images: forces, moments and masses of the whole
// from those of the half alone, and what cancels.
#include <chaindrive/utilities/mirror_symmetry.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

using namespace chaindrive;
using Vector3 = dealii::Tensor<1, 3>;

namespace
{
Vector3 mirrored(Vector3 v)
{
  v[2] = -v[2];
  return v;
}

/// Forces, their moment about the origin, and the masses on which they act.
struct Sums
{
  Vector3 force, moment;
  double  mass = 0.;

  void add(const Vector3 &f, const Vector3 &at, const double m)
  {
    force += f;
    moment += cross_product_3d(at, f);
    mass += m;
  }
};
} // namespace

int main()
{
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (const bool half : {false, true})
    {
      const MirrorSymmetry symmetry(half);
      Sums                 computed, whole;
      for (unsigned int i = 0; i < 20; ++i)
        {
          Vector3 f, at;
          for (unsigned int d = 0; d < 3; ++d)
            {
              f[d]  = uniform(random);
              at[d] = uniform(random);
            }
          const double mass = 1. + uniform(random);
          computed.add(f, at, mass);
          whole.add(f, at, mass);
          if (half)
            whole.add(mirrored(f), mirrored(at), mass);
        }
      Vector3 moment = computed.moment;
      moment *= symmetry.multiplicity();
      symmetry.cancel_tilting(moment.begin_raw());
      Vector3 across = computed.force;
      symmetry.cancel_across(across);
      const double error = std::max({(symmetry.whole_force(computed.force) - whole.force).norm(),
                                     (moment - whole.moment).norm(),
                                     (symmetry.multiplicity() * across - whole.force).norm(),
                                     std::abs(symmetry.whole(computed.mass) - whole.mass),
                                     std::abs(symmetry.share(whole.mass) - computed.mass)});
      std::cout << (half ? "half" : "whole")
                << ": forces, moments and masses to 1e-12: " << (error < 1e-12 ? "yes" : "NO")
                << ", free along " << symmetry.n_free_directions() << ", stations";
      for (const double z : symmetry.axial_positions(0.5))
        std::cout << ' ' << z;
      std::cout << '\n';
    }
}
