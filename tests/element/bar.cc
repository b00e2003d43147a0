// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic bars against closed forms: natural frequencies c / 2 L (free) and c / 4 L (held); a bar
// that flies against a wall is under the pressure rho c v for the time 2 L / c and leaves with the
// impulse 2 m v; two equal bars as one, the first moving, the second at rest, have exchanged their
// velocities when the waves have run over both.
#include "../support/modes.h"

using namespace test;

namespace
{
constexpr double length = 0.1;

/// The lowest axial mode of a quarter of a bar that may contract sideways, Hz.
double axial_frequency(const Hexahedra &reference, const double expected, const bool held)
{
  LinearModel model(reference);
  model.constrain(reference, [&](const Point<3> &x, const unsigned int i) {
    return (i == 0 && held && x[0] < 1e-9) || (i > 0 && x[i] < 1e-9); // and planes of symmetry
  });
  double frequency = 0.;
  for (const Mode &mode : natural_modes(model, expected, 2))
    if (frequency < 0.5 * expected) // leaves out the free bar's rigid motion
      frequency = mode.frequency;
  return frequency;
}
} // namespace

int main()
{
  Material     material;
  const double c = std::sqrt(material.youngs_modulus / material.density);

  std::cout << std::fixed;
  for (const auto &formulation : formulations)
    {
      const mesh::Part body = brick({length, 1e-3, 1e-3}, {50, 1, 1});
      const Hexahedra  reference(body, material, formulation.first);
      std::cout << formulation.second << std::setprecision(5)
                << ", frequency over closed form: free "
                << axial_frequency(reference, c / (2. * length), false) / (c / (2. * length))
                << ", held at one end "
                << axial_frequency(reference, c / (4. * length), true) / (c / (4. * length))
                << '\n';
    }

  // Waves in a bar without lateral contraction, eight speeds at a time.
  material.poissons_ratio = 0.;
  const double h          = 0.5e-3;
  const double area       = h * h;
  const auto   n_cells    = static_cast<unsigned int>(std::lround(length / h));
  const auto   v0         = [](const unsigned int lane) { return 0.25 * (1. + lane); };

  for (const auto &formulation : formulations)
    {
      const mesh::Part body = brick({length, h, h}, {n_cells, 1, 1});
      const Hexahedra  reference(body, material, formulation.first);
      Batch            batch(reference, element::best_kernels());
      for (int lane = 0; lane < n_lanes; ++lane)
        batch.set(batch.velocity, lane, [&](const Point<3> &x, unsigned int) {
          Tensor<1, 3> v;
          v[0] = x[0] < 1e-9 ? 0. : -v0(lane);
          return v;
        });

      const double                dt  = 0.9 * 2. / reference.largest_frequency();
      const double                end = 2. * length / c;
      std::array<double, n_lanes> plateau{}, impulse{}, contact{};
      unsigned int                samples = 0;
      for (double t = 0.; t < 1.2 * end; t += dt)
        {
          samples += (t > 0.1 * end && t < 0.9 * end);
          batch.step(dt, [&](Batch &bar) {
            std::array<double, n_lanes> wall{};
            for (unsigned int node = 0; node < reference.n_nodes(); ++node)
              if (reference.position[node][0] < 1e-9)
                for (int lane = 0; lane < n_lanes; ++lane)
                  {
                    double &f = bar.force[Batch::index(node, 0, lane)];
                    wall[lane] -= f;
                    f = 0.;
                  }
            for (int lane = 0; lane < n_lanes; ++lane)
              if (contact[lane] == 0.)
                {
                  if (t > 0.5 * end && wall[lane] < 0.) // the wall would have to pull
                    contact[lane] = t;
                  else
                    impulse[lane] += wall[lane] * dt;
                  if (t > 0.1 * end && t < 0.9 * end)
                    plateau[lane] += wall[lane] / area;
                }
          });
        }
      std::cout << formulation.second << std::setprecision(3)
                << ", bar against a wall, over closed form, slowest and fastest: pressure";
      const double mass = material.density * area * length;
      for (const int lane : {0, n_lanes - 1})
        std::cout << ' ' << plateau[lane] / samples / (material.density * c * v0(lane));
      std::cout << ", impulse";
      for (const int lane : {0, n_lanes - 1})
        std::cout << ' ' << impulse[lane] / (2. * mass * v0(lane));
      std::cout << ", time";
      for (const int lane : {0, n_lanes - 1})
        std::cout << ' ' << contact[lane] / end;
      std::cout << '\n';
    }

  for (const auto &formulation : formulations)
    {
      const mesh::Part  body = brick({2. * length, h, h}, {2 * n_cells, 1, 1});
      const mesh::Nodes nodes(body);
      const Hexahedra   reference(body, nodes, material, formulation.first);
      Batch             batch(reference, element::best_kernels());
      // the node in the middle belongs to both
      const auto first = [&](const Point<3> &x) {
        return x[0] < length - 1e-9 ? 1. : (x[0] < length + 1e-9 ? 0.5 : 0.);
      };
      for (int lane = 0; lane < n_lanes; ++lane)
        batch.set(batch.velocity, lane, [&](const Point<3> &x, unsigned int) {
          Tensor<1, 3> v;
          v[0] = first(x) * v0(lane);
          return v;
        });

      const double end = 2. * length / c;
      const auto   steps =
          static_cast<unsigned int>(std::ceil(end / (0.9 * 2. / reference.largest_frequency())));
      const double                dt = end / steps;
      std::array<double, n_lanes> pressure{};
      unsigned int                samples = 0;
      for (unsigned int step = 0; step < steps; ++step)
        {
          batch.step(dt);
          if (step < 0.2 * steps || step > 0.8 * steps)
            continue;
          ++samples;
          for (unsigned int e = 0; e < reference.n_elements(); ++e) // those beside the middle
            if (e == n_cells - 1 || e == n_cells)
              for (int lane = 0; lane < n_lanes; ++lane)
                {
                  double now = 0., start = 0.; // length of the element along the bar
                  for (unsigned int a = 0; a < 8; ++a)
                    {
                      const unsigned int node = nodes.cells[e][a];
                      const double       side = (a & 1) != 0 ? 0.25 : -0.25;
                      now += side * batch.position[Batch::index(node, 0, lane)];
                      start += side * reference.position[node][0];
                    }
                  const double stretch = now / start;
                  pressure[lane] -= 0.5 * material.youngs_modulus * (stretch - 1.);
                }
        }
      std::cout << formulation.second << ", two bars, slowest and fastest:";
      for (const int lane : {0, n_lanes - 1})
        {
          double momentum = 0., second = 0., before = 0., energy_second = 0.;
          for (unsigned int node = 0; node < reference.n_nodes(); ++node)
            {
              const double v    = batch.velocity[Batch::index(node, 0, lane)];
              const double m    = reference.mass[node];
              const double part = 1. - first(reference.position[node]);
              before += m * first(reference.position[node]) * v0(lane);
              momentum += m * v;
              second += part * m * v;
              energy_second += part * 0.5 * m * v * v;
            }
          std::cout << " pressure over rho c v / 2 "
                    << pressure[lane] / samples / (0.5 * material.density * c * v0(lane))
                    << ", momentum of the second " << second / before << ", its kinetic energy "
                    << energy_second / (0.5 * before * v0(lane))
                    << ", total momentum kept to 1e-10 "
                    << (std::abs(momentum / before - 1.) < 1e-10 ? "yes" : "NO") << ';';
        }
      std::cout << '\n';
    }
}
