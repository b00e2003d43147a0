// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// One row of a chain standard. A value of zero is not listed there. Lengths in m.
struct CatalogueChain
{
  std::string designation;
  double      pitch;
  double      roller_diameter; ///< of the bush where the chain has no rollers
  double      inner_width;     ///< between the inner plates
  double      pin_diameter;
  double      inner_plate_height, outer_plate_height;
  double      inner_plate_thickness, outer_plate_thickness;
  double      tensile_strength; ///< least ultimate strength, N
  double      mass_per_metre;   ///< kg/m, typical
  bool        has_rollers = true;
};

/// Inch sizes 25 to 240 of ANSI/ASME B29.1.
const std::vector<CatalogueChain> &ansi_chains();

/// ISO 606 series A (04C to 48A); plate thicknesses are those of the ANSI chain of the same pitch.
const std::vector<CatalogueChain> &iso_a_chains();

/// ISO 606 series B (05B to 48B).
const std::vector<CatalogueChain> &iso_b_chains();

/// Motorcycle chains 420 to 630 (ISO 10190): pitch, roller, inner width and strength. The 525 has
/// besides the pin and plate thickness of the chain of Zheng et al. (2004).
const std::vector<CatalogueChain> &motorcycle_chains();

/// The row of @p designation in any of the tables; null if there is none.
const CatalogueChain *find_chain(const std::string &designation);

/// The names of all rows of all tables.
std::vector<std::string> chain_designations();
} // namespace chaindrive::drive
