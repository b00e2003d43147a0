// SPDX-License-Identifier: LGPL-2.1-or-later
// Half a million steps of rollers that spin and ring. With stresses below 1 MPa the energy of the
// vibration stays within a percent and the angular momentum within 1e-9; with 100 MPa the motion
// stays bounded.
#include "../support/modes.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>

#include <algorithm>

using namespace test;

int main()
{
  constexpr unsigned int n_steps = 500000, n_mean = 20000;
  const auto             chain = drive::make_chain(parameters::Chain());
  const Material         material;
  const mesh::Part roller = mesh::make_roller(chain, material.density, mesh::RollerGrid(1, 16, 2));
  const Hexahedra  reference(roller, material, Formulation::enhanced);
  const double     dt = 0.9 * 2. / reference.largest_frequency();
  Batch            batch(reference, element::best_kernels());
  const Vector<double> u = centrifugal_displacements(reference, 1.);

  // Ovalisation of a thin ring: v = a cos 2p outwards and - a/2 sin 2p around. At its frequency w
  // the bending stress of the surface is E 3/2 t (a/w) / R^2.
  const double R                  = 0.25 * (chain.roller_diameter + chain.roller_bore),
               t                  = 0.5 * (chain.roller_diameter - chain.roller_bore);
  const double stress_of_velocity = material.youngs_modulus * 1.5 * t / (R * R) /
                                    (2. * dealii::numbers::PI * 43.04e3); // Pa per m/s
  // at two speeds: without vibration, below 1 MPa, and strong
  const std::array<double, n_lanes> stress{{0., 0.9e6, 0.3e6, 100e6, 0., 0.9e6, 0.3e6, 100e6}};
  const std::array<double, 2>       omega{{120.74, 8. * 120.74}};
  for (int lane = 0; lane < n_lanes; ++lane)
    {
      const double w = omega[lane / 4], a = stress[lane] / stress_of_velocity;
      set_spinning(batch, lane, u, w * w, w, dt);
      for (unsigned int node = 0; node < reference.n_nodes(); ++node)
        {
          const Point<3> &x   = reference.position[node];
          const double    phi = std::atan2(x[1], x[0]);
          const double    out = a * std::cos(2. * phi), round = -0.5 * a * std::sin(2. * phi);
          batch.velocity[Batch::index(node, 0, lane)] +=
              out * std::cos(phi) - round * std::sin(phi);
          batch.velocity[Batch::index(node, 1, lane)] +=
              out * std::sin(phi) + round * std::cos(phi);
        }
    }

  const auto angular_momentum = [&](const unsigned int lane) {
    Tensor<1, 3> sum;
    for (unsigned int node = 0; node < reference.n_nodes(); ++node)
      {
        const Tensor<1, 3> v = batch.get(batch.velocity, node, lane);
        sum += reference.mass[node] *
               cross_product_3d(batch.get(batch.position, node, lane) - 0.5 * dt * v, v);
      }
    return sum;
  };
  std::array<Tensor<1, 3>, n_lanes> start;
  std::array<double, n_lanes>       early{}, late{}, largest{};
  double                            moment = 0.;
  for (unsigned int step = 0; step < n_steps; ++step)
    {
      batch.step(dt);
      const bool first = step < n_mean, last = step >= n_steps - n_mean;
      if (!first && !last && step % 1000 != 0)
        continue;
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          const double energy = batch.total_energy(lane);
          early[lane] += first ? energy / n_mean : 0.;
          late[lane] += last ? energy / n_mean : 0.;
          largest[lane] = std::max(largest[lane], energy); // not a number is never the larger
          if (!(energy < 1e3))
            largest[lane] = std::numeric_limits<double>::infinity();
          if (step % 1000 == 0)
            {
              const Tensor<1, 3> now = angular_momentum(lane);
              if (step == 0)
                start[lane] = now;
              moment = std::max(moment, (now - start[lane]).norm() / start[lane].norm());
            }
        }
    }
  std::cout << "angular momentum kept to 1e-9: " << (moment < 1e-9 ? "yes" : "NO") << '\n';
  for (int lane = 0; lane < n_lanes; ++lane)
    if (stress[lane] > 0.)
      {
        // what vibrates is what a roller without vibration does not have
        const int    still  = lane / 4 * 4;
        const double before = early[lane] - early[still], after = late[lane] - late[still];
        std::cout << omega[lane / 4] << " rad/s, " << stress[lane] * 1e-6 << " MPa: ";
        if (stress[lane] < 1e6)
          std::cout << "energy of the vibration within 1 %: "
                    << (std::abs(after / before - 1.) < 0.01 ? "yes" : "NO") << '\n';
        else
          std::cout << "total energy bounded by twice that of the start: "
                    << (largest[lane] < 2. * early[lane] ? "yes" : "NO") << '\n';
      }
}
