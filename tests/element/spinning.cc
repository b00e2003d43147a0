// SPDX-License-Identifier: LGPL-2.1-or-later
// A thin ring and an annular disc that spin freely, eight speeds at a time, against the theories of
// plane stress. They start in static balance with the centrifugal forces and are stepped for five
// periods of their breathing.
#include "../support/modes.h"

#include <chaindrive/mesh/gauss_points.h>

#include <algorithm>
#include <vector>

using namespace test;

namespace
{
/// Means over time of one body.
struct Means
{
  double              growth = 0.;          ///< of the radius of the bore, m
  std::vector<double> hoop, radial, radius; ///< stress and place of each ring of cells, Pa and m
};

std::array<Means, n_lanes> spin(const Hexahedra                   &reference,
                                const std::array<unsigned int, 3> &cells,
                                const double                       bore,
                                const std::array<double, n_lanes> &omega,
                                const double                       duration)
{
  const double         dt = 0.9 * 2. / reference.largest_frequency();
  Batch                batch(reference, element::best_kernels());
  const Vector<double> u = centrifugal_displacements(reference, 1.);
  for (int lane = 0; lane < n_lanes; ++lane)
    set_spinning(batch, lane, u, omega[lane] * omega[lane], omega[lane], dt);

  std::array<Means, n_lanes> means;
  for (Means &mean : means)
    {
      mean.hoop.resize(cells[0]);
      mean.radial.resize(cells[0]);
      mean.radius.resize(cells[0]);
    }
  std::vector<std::array<Tensor<1, 3>, 8>> gradient(reference.n_elements()); // mean per element
  for (unsigned int e = 0; e < reference.n_elements(); ++e)
    {
      mesh::Corners corners;
      for (unsigned int a = 0; a < 8; ++a)
        corners[a] = reference.position[reference.vertices[e].node[a]];
      double volume = 0.;
      for (const mesh::GaussPoint &point : mesh::gauss_points(corners))
        {
          volume += point.volume;
          for (unsigned int a = 0; a < 8; ++a)
            gradient[e][a] += point.volume * point.gradient[a];
        }
      for (Tensor<1, 3> &g : gradient[e])
        g /= volume;
    }
  unsigned int n_samples = 0, n_bore = 0;
  for (const Point<3> &x : reference.position)
    n_bore += (std::hypot(x[0], x[1]) < bore + 1e-9);
  const auto n_steps = static_cast<unsigned int>(std::ceil(duration / dt));
  for (unsigned int step = 0; step < n_steps; ++step)
    {
      batch.step(dt);
      if (step % 10 != 0)
        continue;
      ++n_samples;
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          Means &mean = means[lane];
          for (unsigned int node = 0; node < reference.n_nodes(); ++node)
            {
              const Point<3>    &x = reference.position[node];
              const Tensor<1, 3> p = batch.get(batch.position, node, lane);
              if (std::hypot(x[0], x[1]) < bore + 1e-9)
                mean.growth += (std::hypot(p[0], p[1]) - bore) / n_bore;
            }
          for (unsigned int e = 0; e < reference.n_elements(); ++e)
            {
              const element::Vertices &element = reference.vertices[e];
              Tensor<2, 3>             F;
              Point<3>                 middle;
              for (unsigned int a = 0; a < 8; ++a)
                {
                  middle += 0.125 * reference.position[element.node[a]];
                  for (unsigned int i = 0; i < 3; ++i)
                    for (unsigned int j = 0; j < 3; ++j)
                      F[i][j] += batch.position[Batch::index(element.node[a], i, lane)] *
                                 gradient[e][a][j];
                }
              Tensor<2, 3> S = transpose(F) * F;
              for (unsigned int i = 0; i < 3; ++i)
                S[i][i] -= 1.;
              const double pressure = 0.5 * reference.lambda * trace(S);
              S *= reference.mu;
              for (unsigned int i = 0; i < 3; ++i)
                S[i][i] += pressure;
              const double r = std::hypot(middle[0], middle[1]);
              Tensor<1, 3> out;
              out[0]                    = middle[0] / r;
              out[1]                    = middle[1] / r;
              const unsigned int here   = e % cells[0];
              const double       radial = out * S * out;
              mean.radius[here] += r / cells[1];
              mean.radial[here] += radial / cells[1];
              mean.hoop[here] += (S[0][0] + S[1][1] - radial) / cells[1];
            }
        }
    }
  for (Means &mean : means)
    {
      mean.growth /= n_samples;
      for (unsigned int k = 0; k < cells[0]; ++k)
        {
          mean.hoop[k] /= n_samples;
          mean.radial[k] /= n_samples;
          mean.radius[k] /= n_samples;
        }
    }
  return means;
}
} // namespace

int main()
{
  const Material material;
  const double   E = material.youngs_modulus, nu = material.poissons_ratio, rho = material.density;
  const double   c = std::sqrt(E / rho);
  std::array<double, n_lanes> omega;
  for (int lane = 0; lane < n_lanes; ++lane)
    omega[lane] = 120.74 * (1. + lane);

  std::cout << std::fixed << std::setprecision(3);
  for (const auto &formulation : formulations)
    {
      const double                      r = 0.1, t = 1e-3;
      const std::array<unsigned int, 3> cells{{1, 96, 1}};
      const mesh::Part                  body = ring(r - 0.5 * t, r + 0.5 * t, 5e-3, cells);
      const Hexahedra                   reference(body, material, formulation.first);
      const auto                        means =
          spin(reference, cells, r - 0.5 * t, omega, 5. * 2. * dealii::numbers::PI * r / c);
      std::cout << formulation.second
                << ", thin ring over theory, slowest and fastest: hoop stress";
      for (const int lane : {0, n_lanes - 1})
        std::cout << ' ' << means[lane].hoop[0] / (rho * r * r * omega[lane] * omega[lane]);
      std::cout << ", growth";
      for (const int lane : {0, n_lanes - 1})
        std::cout << ' ' << means[lane].growth / (rho * r * r * r * omega[lane] * omega[lane] / E);
      std::cout << '\n';
    }

  for (const auto &formulation : formulations)
    {
      const double                      a = 12.5e-3, b = 33.1e-3;
      const std::array<unsigned int, 3> cells{{10, 56, 1}};
      const mesh::Part                  body = ring(a, b, 1e-3, cells);
      const Hexahedra                   reference(body, material, formulation.first);
      const auto means = spin(reference, cells, a, omega, 5. * dealii::numbers::PI * (a + b) / c);
      std::cout << formulation.second
                << ", disc over theory, slowest and fastest: hoop at the bore";
      for (const int lane : {0, n_lanes - 1}) // E u / r, as there is no other stress
        std::cout << ' '
                  << E * means[lane].growth / a /
                         (0.25 * rho * omega[lane] * omega[lane] *
                          ((3. + nu) * b * b + (1. - nu) * a * a));
      std::cout << ", largest radial";
      for (const int lane : {0, n_lanes - 1})
        std::cout << ' '
                  << *std::max_element(means[lane].radial.begin(), means[lane].radial.end()) /
                         ((3. + nu) / 8. * rho * omega[lane] * omega[lane] * (b - a) * (b - a));

      double error = 0.;
      for (int lane = 0; lane < n_lanes; ++lane)
        for (unsigned int k = 0; k < cells[0]; ++k)
          {
            const double r = means[lane].radius[k];
            const double hoop =
                (3. + nu) / 8. * rho * omega[lane] * omega[lane] *
                (a * a + b * b + a * a * b * b / (r * r) - (1. + 3. * nu) / (3. + nu) * r * r);
            error = std::max(error, std::abs(means[lane].hoop[k] / hoop - 1.));
          }
      std::cout << ", hoop at all radii and speeds within 1 %: " << (error < 0.01 ? "yes" : "NO")
                << '\n';
    }
}
