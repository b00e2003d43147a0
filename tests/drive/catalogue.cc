// SPDX-License-Identifier: LGPL-2.1-or-later

// Every value of the chain tables: pitch, roller, inner width, pin, plate heights inner and outer,
// plate thicknesses inner and outer (mm), strength (kN), mass (kg/m); 0: not listed.

#include <chaindrive/drive/catalogue.h>

#include <iostream>

using namespace chaindrive::drive;

int main()
{
  for (const auto &[name, table] :
       {std::pair<const char *, const std::vector<CatalogueChain> &>{"ANSI", ansi_chains()},
        {"ISO 606 A", iso_a_chains()},
        {"ISO 606 B", iso_b_chains()},
        {"motorcycle", motorcycle_chains()}})
    {
      std::cout << "== " << name << '\n';
      for (const CatalogueChain &c : table)
        {
          std::cout << c.designation;
          for (const double length : {c.pitch,
                                      c.roller_diameter,
                                      c.inner_width,
                                      c.pin_diameter,
                                      c.inner_plate_height,
                                      c.outer_plate_height,
                                      c.inner_plate_thickness,
                                      c.outer_plate_thickness})
            std::cout << ' ' << length * 1e3;
          std::cout << ' ' << c.tensile_strength * 1e-3 << ' ' << c.mass_per_metre
                    << (c.has_rollers ? "" : " rollerless") << '\n';
        }
    }
}
