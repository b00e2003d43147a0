// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh of a roller is a prism over a ring of two regular polygons: its volume, area and polar
// moment have closed forms, which tend to those of the solid as 1/n^2.

#include <chaindrive/element/part_report.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/mass.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;

int main()
{
  const auto   chain = drive::make_chain(parameters::Chain());
  Material     material;
  const double R = 0.5 * chain.roller_diameter, r = 0.5 * chain.roller_bore;
  const double solid = dealii::numbers::PI * (R * R - r * r) * chain.roller_length;

  std::cout << std::fixed
            << "around, volume and outside over closed form, error of the volume in %, "
            << "its order, error of the inertia in %\n";
  double last = 0.;
  for (const unsigned int n : {12, 24, 48, 96})
    {
      const mesh::Part          part   = mesh::make_roller(chain, material.density, {2, n, 2});
      const element::PartReport report = element::make_report(part, material);

      const double angle   = 2. * dealii::numbers::PI / n;
      const double polygon = 0.5 * n * std::sin(angle) * (R * R - r * r) * chain.roller_length;
      const double side    = 2. * n * R * std::sin(0.5 * angle) * chain.roller_length;
      const double volume  = mesh::component_volumes(*part.mesh)[mesh::roller];
      const double error   = 1. - volume / solid;
      std::cout << n << std::setprecision(8) << ' ' << volume / polygon << ' '
                << report.sides[0].area / side << std::setprecision(4) << ' ' << 100. * error
                << ' ';
      if (last > 0.)
        std::cout << std::setprecision(2) << std::log2(last / error);
      std::cout << std::setprecision(4) << ' ' << 100. * report.meshed_error[2] << '\n';
      last = error;

      if (std::abs(part.meshed.mass / part.exact.mass - 1.) > 1e-12)
        std::cout << "mass " << part.meshed.mass / part.exact.mass << '\n';
    }
}
