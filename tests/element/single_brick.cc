// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest natural frequency of single bricks against closed forms. A free cube with lumped
// masses is limited by its breathing mode: dt = h / (sqrt(3) c_K), c_K^2 = K / rho; for a flat
// brick the limit tends to that of a bar of constrained cross-section, dt = h / c_d. A report on a
// roller.

#include <chaindrive/element/hexahedron_stiffness.h>
#include <chaindrive/element/part_report.h>
#include <chaindrive/mesh/generate/links.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;

int main()
{
  const Material material;
  const double   E = material.youngs_modulus, nu = material.poissons_ratio, rho = material.density;
  const double   bulk = E / (3. * (1. - 2. * nu));
  const double   c_k  = std::sqrt(bulk / rho),
               c_d    = std::sqrt(E * (1. - nu) / ((1. + nu) * (1. - 2. * nu) * rho));

  const auto step = [&](const double a, const double b, const double c) {
    mesh::Corners x;
    for (unsigned int v = 0; v < 8; ++v)
      x[v] = dealii::Point<3>((v & 1) * a, ((v >> 1) & 1) * b, (v >> 2) * c);
    return 2. / element::largest_frequency(x, material, rho);
  };
  const double h = 1e-3;
  std::cout << std::fixed << std::setprecision(6) << "cube: step over h / (sqrt(3) c_K) "
            << step(h, h, h) * std::sqrt(3.) * c_k / h << '\n';
  std::cout << std::setprecision(3) << "step over h / c_d: cube " << step(h, h, h) * c_d / h
            << ", 1 x 1 x 2 " << step(h, h, 2. * h) * c_d / h << ", 0.3 x 1 x 1 "
            << step(0.3 * h, h, h) * c_d / (0.3 * h) << '\n';
  std::cout << "flat, 1 x 50 x 50: " << step(h, 50. * h, 50. * h) * c_d / h << '\n';

  // The true limit of this mesh is 0.1078 us (Lanczos); the bound by single cells is 10 to 26 %
  // less.
  const auto chain = drive::make_chain(parameters::Chain());
  element::print(std::cout, {element::make_report(mesh::make_roller(chain, rho, 2), material)});
}
