// SPDX-License-Identifier: LGPL-2.1-or-later
// Free vibration in one natural mode, another in every lane: leapfrog with the step dt has the
// frequency (2 / dt) asin(omega dt / 2), an error of second order.
#include "../support/modes.h"

#include <vector>

using namespace test;

int main()
{
  const Material material;
  mesh::Part     body = brick({2e-3, 2e-3, 2e-3}, {2, 2, 2});
  dealii::GridTools::distort_random(0.2, *body.mesh, /*keep_boundary*/ false, 3);

  std::cout << std::fixed << std::setprecision(2);
  for (const auto &formulation : formulations)
    {
      const Hexahedra   reference(body, material, formulation.first);
      const LinearModel model(reference);
      std::vector<Mode> modes = natural_modes(model, 1.2e6, n_lanes);

      std::array<double, 3> error{};
      double                from_formula = 0.;
      for (unsigned int level = 0; level < 3; ++level)
        {
          const double dt = 0.5 / (1u << level) / reference.largest_frequency();
          Batch        batch(reference, element::best_kernels());
          for (int lane = 0; lane < n_lanes; ++lane)
            {
              const double scale = 1e-10 / modes[lane].vector.linfty_norm();
              batch.set(batch.position, lane, [&](const Point<3> &x, const unsigned int node) {
                Tensor<1, 3> p = x;
                for (unsigned int i = 0; i < 3; ++i)
                  p[i] += scale * modes[lane].vector[3 * node + i];
                return p;
              });
            }

          // a(t - dt) + a(t + dt) = 2 cos(omega dt) a(t), a the amplitude of the mode
          std::array<double, n_lanes> before{}, here{}, products{}, squares{};
          for (unsigned int step = 0; step < 2000; ++step)
            {
              batch.step(dt);
              for (int lane = 0; lane < n_lanes; ++lane)
                {
                  double next = 0.;
                  for (unsigned int node = 0; node < reference.n_nodes(); ++node)
                    for (unsigned int i = 0; i < 3; ++i)
                      next += reference.mass[node] * modes[lane].vector[3 * node + i] *
                              (batch.position[Batch::index(node, i, lane)] -
                               reference.position[node][i]);
                  if (step > 1)
                    {
                      products[lane] += here[lane] * (before[lane] + next);
                      squares[lane] += here[lane] * here[lane];
                    }
                  before[lane] = here[lane];
                  here[lane]   = next;
                }
            }
          for (int lane = 0; lane < n_lanes; ++lane)
            {
              const double exact    = 2. * dealii::numbers::PI * modes[lane].frequency;
              const double obtained = std::acos(products[lane] / (2. * squares[lane])) / dt;
              error[level]          = std::max(error[level], std::abs(obtained / exact - 1.));
              from_formula          = std::max(
                  from_formula, std::abs(obtained / (2. / dt * std::asin(0.5 * exact * dt)) - 1.));
            }
        }
      std::cout << formulation.second << ": order of the frequency in the step "
                << std::log2(error[0] / error[1]) << ' ' << std::log2(error[1] / error[2])
                << "; as the formula to 1e-6: " << (from_formula < 1e-6 ? "yes" : "NO") << '\n';
    }
}
