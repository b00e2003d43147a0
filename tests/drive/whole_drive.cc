// SPDX-License-Identifier: LGPL-2.1-or-later

// Whole drives from parameters alone: the default one, and other sizes whose masses must come near
// those of catalogues, given that plates are estimates; what the log says of choices made.

#include "compare.h"

#include <chaindrive/drive/drive.h>

using namespace chaindrive;

int main()
{
  std::cout << "== default: 525, 15/42, 110 links\n";
  const drive::Drive d = drive::make_drive(Parameters());
  compare("tight tension from 150 N m, N", d.nominal_tension, 1412.2, 1);
  // 13.843 g with both hole pitches 15.875, less 0.09 mm of two outer plates' waists per two
  // pitches
  compare("mass per pitch, g",
          d.mass_per_pitch * 1e3,
          13.843 - 0.09 * 0.7 * 13.02 * 2. * 7600. * 1e-6,
          2);
  compare("roller-tooth stiffness, kN/mm", d.roller_tooth_stiffness * 1e-6, 301.14, 2);
  verdict("layout of 110 joints", d.layout.joints.size() == 110);
  for (const std::string &note : d.notes)
    std::cout << note << '\n';

  std::cout << "== mass per metre over the catalogue's\n";
  double least = 1e9, most = 0.;
  for (const std::string &name : drive::chain_designations())
    {
      const drive::CatalogueChain *row = drive::find_chain(name);
      if (row->mass_per_metre == 0.)
        continue;
      parameters::Chain chain;
      chain.designation = name;
      const auto   c    = drive::make_chain(chain);
      const double mass =
          drive::roller_solid(c, 7800.).mass +
          0.5 * (drive::inner_link_solid(c, 7800.).mass + drive::outer_link_solid(c, 7800.).mass);
      const double ratio = mass / c.pitch / row->mass_per_metre;
      least              = std::min(least, ratio);
      most               = std::max(most, ratio);
      std::cout << name << ' ' << std::setprecision(3) << ratio << '\n';
    }
  verdict("all within 0.75 and 1.25", least > 0.75 && most < 1.25);

  std::cout << "== other drives: centre distance mm, stiffness per pitch kN/mm\n";
  for (const auto &[name, z1, z2, n] :
       {std::tuple<const char *, unsigned, unsigned, unsigned>{"08B", 19, 57, 140},
        {"12A", 11, 23, 80},
        {"06B", 25, 25, 100},
        {"525", 14, 41, 108},
        {"25", 9, 30, 90},
        {"48B", 13, 13, 50}})
    for (const std::string fidelity : {"simple", "layered"})
      {
        Parameters p;
        p.drive.chain.designation        = name;
        p.drive.sprockets.driver().teeth = z1;
        p.drive.sprockets.driven().teeth = z2;
        p.drive.n_links                  = n;
        p.model.fidelity                 = fidelity;
        if (n == 90) // the default load would press its rollers through the teeth
          p.loads.resisting_torque = 5.;
        const drive::Drive other = drive::make_drive(p);
        std::cout << name << ' ' << z1 << '/' << z2 << ' ' << fidelity << ' '
                  << std::setprecision(4) << other.layout.centre_distance() * 1e3 << ' '
                  << std::setprecision(3) << other.stiffness_per_pitch * 1e-6 << '\n';
      }

  std::cout << "== refused\n";
  expect_refusal("sprocket wider than the chain", [] {
    Parameters p;
    p.drive.sprockets.width = 8e-3;
    drive::make_drive(p);
  });
  expect_refusal("bore larger than the hub", [] {
    Parameters p;
    p.drive.sprockets.driver().bore         = 40e-3;
    p.drive.sprockets.driver().hub_diameter = 33e-3;
    drive::make_drive(p);
  });
}
