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
  double      tensile_strength; ///< least ultimate strength of one strand, N
  double      mass_per_metre;   ///< of one strand, kg/m, typical
  bool        has_rollers = true;

  /// Least ultimate strength of two and of three strands where it is not twice and three times that
  /// of one, N.
  double duplex_strength = 0., triplex_strength = 0.;

  /// That of so many strands, N: of four and more that of a triplex chain for each three. Zero
  /// where that of one is not listed.
  double strength_of(unsigned int strands) const;
};

/// Inch sizes 25 to 240 of ANSI/ASME B29.1, and the heavy series 60H to 240H of the same with
/// thicker plates, which ISO 606 has too.
const std::vector<CatalogueChain> &ansi_chains();

/// ISO 606 series A (04C to 48A); plate thicknesses are those of the ANSI chain of the same pitch.
const std::vector<CatalogueChain> &iso_a_chains();

/// ISO 606 series B (05B to 72B).
const std::vector<CatalogueChain> &iso_b_chains();

/// Bicycle chains 081C (1/2 x 1/8 inch) and 082C (1/2 x 3/32 inch) of ISO 9633.
const std::vector<CatalogueChain> &bicycle_chains();

/// Motorcycle chains 415 to 630 (ISO 10190) and the kart chain 219: pitch, roller, inner width and
/// strength. The 525 has besides the pin and plate thickness of the chain of Zheng et al. (2004).
const std::vector<CatalogueChain> &motorcycle_chains();

/// The row of @p designation in any of the tables; null if there is none.
const CatalogueChain *find_chain(const std::string &designation);

/// Distance of the middle planes of two neighbouring strands of the chain @p designation, m: the
/// transverse pitch of ISO 606, of its series A and B, of the ANSI sizes, which are those of series
/// A, and of the heavy ones. 0 where it is not listed.
double transverse_pitch_of(const std::string &designation);

/// The names of all rows of all tables.
std::vector<std::string> chain_designations();
} // namespace chaindrive::drive
