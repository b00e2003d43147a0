// SPDX-License-Identifier: LGPL-2.1-or-later
// A roller turned by any angle 0.6 m from the origin is free of strain and of forces. A roller that
// spins ten times about its axis, which points into another direction in every lane, keeps the
// strain energy of centrifugal stretching with which it starts, and nothing is added to it; total
// energy is constant and the angular momentum is kept to round-off. Started without the stretching
// it breathes, and its energy does not grow either.
#include "../support/modes.h"

#include <numeric>
#include <vector>

using namespace test;

int main()
{
  const Material     material;
  const mesh::Part   body = ring(3.76e-3, 5.08e-3, 7e-3, {{1, 16, 2}});
  const Tensor<1, 3> far  = Point<3>(0.4, -0.4, 0.2); // 0.6 m

  for (const Kind &kind : kinds)
    {
      const Hexahedra reference = elements_of(body, material, kind);
      const double    volume =
          std::accumulate(reference.mass.begin(), reference.mass.end(), 0.) / body.density;

      Batch  batch(reference, element::best_kernels());
      double strain = 0., force = 0.;
      for (unsigned int k = 0; k < 9; ++k)
        {
          for (int lane = 0; lane < n_lanes; ++lane)
            {
              const Tensor<2, 3> turned =
                  turn((n_lanes * k + lane) * dealii::numbers::PI / 36.); // every 5 degrees
              batch.set(batch.position, lane, [&](const Point<3> &x, unsigned int) {
                return far + turned * x;
              });
            }
          batch.force.fill(0.);
          batch.add_internal_forces();
          for (const double f : batch.force)
            force = std::max(force, std::abs(f) / (material.youngs_modulus * 2e-6)); // 2 mm2
          for (int lane = 0; lane < n_lanes; ++lane)
            strain =
                std::max(strain,
                         std::sqrt(2. * (batch.strain_energy(lane) + batch.hourglass_energy(lane)) /
                                   (material.youngs_modulus * volume)));
        }
      std::cout << kind.name << ", turned by 0, 5 ... 355 degrees: strain below 1e-12: "
                << (strain < 1e-12 ? "yes" : "NO")
                << "; forces below 1e-12 of E times a cell's side: "
                << (force < 1e-12 ? "yes" : "NO") << '\n';

      const double       omega = 8000.; // rim at 40 m/s
      const double       dt    = 0.9 * 2. / reference.largest_frequency();
      const unsigned int turns = 10;
      const auto         per_turn =
          static_cast<unsigned int>(std::lround(2. * dealii::numbers::PI / (omega * dt)));
      const Vector<double> stretching = centrifugal_displacements(reference, omega);

      double static_energy = 0.; // half the work of the centrifugal forces
      for (unsigned int i = 0; i < stretching.size(); ++i)
        if (i % 3 < 2)
          static_energy += 0.5 * omega * omega * reference.mass[i / 3] *
                           reference.position[i / 3][i % 3] * stretching[i];

      for (const bool stretched : {true, false})
        {
          Batch spinning(reference, element::best_kernels());
          for (int lane = 0; lane < n_lanes; ++lane)
            set_spinning(
                spinning, lane, stretching, stretched ? 1. : 0., omega, dt, turn(0.7 * lane), far);

          const auto momentum = [&](const unsigned int lane) {
            Tensor<1, 3> l;
            for (unsigned int node = 0; node < reference.n_nodes(); ++node)
              l += reference.mass[node] *
                   cross_product_3d(spinning.get(spinning.position, node, lane) - far,
                                    spinning.get(spinning.velocity, node, lane));
            return l;
          };
          std::array<Tensor<1, 3>, n_lanes> start;
          std::array<double, n_lanes>       energy, first{}, last{};
          for (int lane = 0; lane < n_lanes; ++lane)
            start[lane] = momentum(lane);

          double change = 0., lost = 0., least = 1e30, most = 0.;
          for (unsigned int step = 0; step < turns * per_turn; ++step)
            {
              spinning.step(dt);
              for (int lane = 0; lane < n_lanes; ++lane)
                {
                  const double stored =
                      spinning.strain_energy(lane) + spinning.hourglass_energy(lane);
                  if (step == 0)
                    energy[lane] = spinning.total_energy(lane);
                  if (step < per_turn)
                    first[lane] += stored / per_turn;
                  if (step >= (turns - 1) * per_turn)
                    last[lane] += stored / per_turn;
                  change = std::max(change, std::abs(spinning.total_energy(lane) - energy[lane]));
                  least  = std::min(least, stored);
                  most   = std::max(most, stored);
                }
            }
          double growth = 0.;
          for (int lane = 0; lane < n_lanes; ++lane)
            {
              lost   = std::max(lost, (momentum(lane) - start[lane]).norm() / start[lane].norm());
              growth = std::max(growth, std::abs(last[lane] / first[lane] - 1.));
            }
          // started round, it breathes about the stretched state: half as much again
          const double expected = (stretched ? 1. : 1.5) * static_energy;
          std::cout << kind.name << ", ten turns, started " << (stretched ? "stretched" : "round")
                    << ": stored energy of the last turn as in theory to 1 %: "
                    << (std::abs(last[0] / expected - 1.) < 0.01 ? "yes" : "NO")
                    << ", and as in the first: " << (growth < 0.01 ? "yes" : "NO");
          if (stretched)
            std::cout << ", at no time another to 1e-4: "
                      << (least > (1. - 1e-4) * first[0] && most < (1. + 1e-4) * first[0] ? "yes" :
                                                                                            "NO");
          std::cout << "; change of the total energy below 1 % of it: "
                    << (change < 0.01 * first[0] ? "yes" : "NO")
                    << "; angular momentum kept to 1e-10: " << (lost < 1e-10 ? "yes" : "NO")
                    << '\n';
        }
    }
}
