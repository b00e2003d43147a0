// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of hard elements, free, spinning and vibrating at random, at nine tenths of the critical
// time step: one element, twenty times as long as thick, a corner with two hundredths of the
// volume, nearly incompressible. Momentum and angular momentum stay what they were; the energy,
// averaged over a thousand steps, neither grows nor fades.
#include "../support/elastic.h"

#include <algorithm>
#include <vector>

using namespace test;

namespace
{
struct Sums
{
  double       energy = 0.;
  Tensor<1, 3> momentum, moment; ///< about the origin
};

Sums sums(const Batch &batch, const unsigned int lane, const double dt)
{
  Sums s;
  s.energy = batch.total_energy(lane);
  for (unsigned int node = 0; node < batch.reference.n_nodes(); ++node)
    {
      const Tensor<1, 3> v = batch.get(batch.velocity, node, lane);
      // half a step back, where the velocities are: with forces between nodes only it is constant
      const Tensor<1, 3> x = batch.get(batch.position, node, lane) - 0.5 * dt * v;
      s.momentum += batch.reference.mass[node] * v;
      s.moment += batch.reference.mass[node] * cross_product_3d(x, v);
    }
  return s;
}

/// Pushes one corner of the brick towards the opposite one of its cell, until its Jacobian there is
/// @p left of what it was: it is none when a third of the way is done.
void make_sliver(mesh::Part &part, const double left)
{
  const auto cell = part.mesh->begin_active();
  cell->vertex(0) += (1. - left) / 3. * (cell->vertex(7) - cell->vertex(0));
}
} // namespace

int main()
{
  struct Body
  {
    std::string               name;
    Point<3>                  size;
    std::vector<unsigned int> cells;
    double                    poisson, sliver;
  };
  const std::vector<Body> bodies = {
      {"one element", {1e-3, 1e-3, 1e-3}, {1, 1, 1}, 0.3, 1.},
      {"one element, nu 0.495", {1e-3, 1e-3, 1e-3}, {1, 1, 1}, 0.495, 1.},
      {"aspect ratio 20", {8e-3, 0.4e-3, 0.4e-3}, {2, 2, 2}, 0.3, 1.},
      {"flat, 20 x 20 x 1", {8e-3, 8e-3, 0.4e-3}, {2, 2, 2}, 0.3, 1.},
      {"sliver", {2e-3, 2e-3, 2e-3}, {2, 2, 2}, 0.3, 0.02},
      {"nu 0.495", {2e-3, 2e-3, 2e-3}, {2, 2, 2}, 0.495, 1.},
  };
  const unsigned int n_steps = 50000, n_mean = 1000;
  for (const Body &body : bodies)
    for (const auto &formulation : formulations)
      {
        mesh::Part part = brick(body.size, body.cells);
        if (body.sliver < 1.)
          make_sliver(part, body.sliver);
        Material material;
        material.poissons_ratio = body.poisson;
        const Hexahedra reference(part, material, formulation.first);
        const double    dt = 0.9 * 2. / reference.largest_frequency();

        Batch                                  batch(reference, element::best_kernels());
        std::mt19937                           random(1);
        std::uniform_real_distribution<double> uniform(-1., 1.);
        for (int lane = 0; lane < n_lanes; ++lane)
          batch.set(batch.velocity, lane, [&](const Point<3> &x, unsigned int) {
            Tensor<1, 3> v, spin; // of about 0.3 MPa, and up to 800 rad/s
            spin[0] = spin[2] = 100. * lane;
            for (unsigned int i = 0; i < 3; ++i)
              v[i] = 0.01 * uniform(random);
            return v + cross_product_3d(spin, x);
          });

        std::array<Sums, n_lanes>   first{};
        std::array<double, n_lanes> early{}, late{};
        double                      momentum = 0., moment = 0.;
        for (unsigned int step = 0; step < n_steps; ++step)
          {
            batch.step(dt);
            if (step >= n_mean && step < n_steps - n_mean && step % 100 != 0)
              continue;
            for (int lane = 0; lane < n_lanes; ++lane)
              {
                const Sums now = sums(batch, lane, dt);
                if (step == 0)
                  first[lane] = now;
                if (step < n_mean)
                  early[lane] += now.energy / n_mean;
                if (step >= n_steps - n_mean)
                  late[lane] += now.energy / n_mean;
                momentum = std::max(momentum,
                                    (now.momentum - first[lane].momentum).norm() /
                                        first[lane].momentum.norm());
                moment   = std::max(
                    moment, (now.moment - first[lane].moment).norm() / first[lane].moment.norm());
              }
          }
        double drift = 0.;
        for (int lane = 0; lane < n_lanes; ++lane)
          drift = std::max(drift, std::abs(late[lane] / early[lane] - 1.));
        std::cout << body.name << ", " << formulation.second
                  << ": momentum and its moment to 1e-9: "
                  << (momentum < 1e-9 && moment < 1e-9 ? "yes" : "NO")
                  << "; energy to 1 %: " << (drift < 0.01 ? "yes" : "NO") << '\n';
      }
}
