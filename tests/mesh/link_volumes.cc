// SPDX-License-Identifier: LGPL-2.1-or-later
// Volumes of the components of links tend to those of the solids with order 2; the density factors
// make up for the rest, and for the bush that its mesh leads through the plate.

#include <chaindrive/element/part_report.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/mass.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;

namespace
{
void study(const std::string &what, const drive::ChainDimensions &chain, const bool inner)
{
  const Material     material;
  const double       density = material.density;
  const drive::Plate plate   = inner ? drive::inner_plate(chain) : drive::outer_plate(chain);
  const double       plates  = 2. * drive::plate_solid(plate, density).mass / density;
  const double       tube =
      2. * (inner ? drive::bush_solid(chain, density) : drive::pin_solid(chain, density)).mass /
      density;
  const double length  = inner ? chain.bush_length : chain.pin_length;
  const double to_face = tube * (length + plate.thickness) / length;

  std::cout << what << "\naround, errors of the volumes of plates and tubes in %, "
            << "density factors, errors of the inertia in %\n";
  std::vector<double> plate_errors, tube_errors;
  for (const unsigned int n : {16, 32, 64})
    {
      const mesh::LinkGrid grid     = {n, 1, n / 16, 1, 2};
      const mesh::Part     part     = inner ? mesh::make_inner_link(chain, density, grid) :
                                              mesh::make_outer_link(chain, density, grid);
      const auto           volumes  = mesh::component_volumes(*part.mesh);
      const auto           ids      = inner ? std::make_pair(mesh::inner_plate, mesh::bush) :
                                              std::make_pair(mesh::outer_plate, mesh::pin);
      const double         e_plates = 1. - volumes[ids.first] / plates;
      const double         e_tube   = 1. - volumes[ids.second] / to_face;
      std::cout << n << std::setprecision(4) << ' ' << 100. * e_plates << ' ' << 100. * e_tube;
      std::cout << std::setprecision(5) << ", " << part.density_factor[ids.first] << ' '
                << part.density_factor[ids.second];
      const element::PartReport report = element::make_report(part, material);
      std::cout << std::setprecision(3);
      for (unsigned int d = 0; d < 3; ++d)
        std::cout << (d == 0 ? ", " : " ") << 100. * report.meshed_error[d];
      std::cout << '\n';
      plate_errors.push_back(e_plates);
      tube_errors.push_back(e_tube);
      if (!(std::abs(report.mass_error) < 1e-12 && part.meshed.centre.norm() < 1e-12))
        std::cout << "mass " << report.mass_error << ", centre " << part.meshed.centre << '\n';
    }
  // the corner at mid-pitch takes the nearest grid line, so that single steps scatter
  const auto order = [](const std::vector<double> &e) { return 0.5 * std::log2(e[0] / e[2]); };
  std::cout << std::setprecision(2) << "mean orders " << order(plate_errors) << ' '
            << order(tube_errors) << '\n';
}
} // namespace

int main()
{
  std::cout << std::fixed;
  const auto chain = drive::make_chain(parameters::Chain());
  study("inner link", chain, true);
  study("outer link", chain, false);

  parameters::Chain solid_pins;
  solid_pins.pin_bore    = 0.;
  solid_pins.waist_ratio = 1.;
  study("outer link with solid pins and straight plates", drive::make_chain(solid_pins), false);
}
