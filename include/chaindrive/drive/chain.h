// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/catalogue.h>
#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/loads.h>

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// Dimensions of a roller chain, in m.
///
/// Bushes and pins end in the mid-surfaces of the plates that carry them: bush_length is the
/// distance of the inner plates' mid-surfaces, pin_length that of the outer plates'.
///
/// Of a chain without rollers, a bush chain, the bush is what meets the teeth: roller_diameter and
/// roller_bore are its diameter, so that a roller has no wall and no mass, and roller_length is the
/// length between the inner plates.
struct ChainDimensions
{
  std::string designation;
  bool        has_rollers = true;
  double      pitch; ///< nominal
  double      roller_diameter, roller_bore, roller_length;
  double      bush_diameter, bush_bore, bush_length;
  double      pin_diameter, pin_bore, pin_length; ///< pin_bore is 0 for a solid pin
  double      inner_width;                        ///< between the inner plates
  double      inner_plate_height, inner_plate_thickness, inner_plate_z; ///< z of the mid-surface
  double      outer_plate_height, outer_plate_thickness, outer_plate_z; ///< z of the mid-surface
  double      waist_ratio; ///< plate height at mid-pitch / plate height, at most 1
  double      inner_hole_pitch, outer_hole_pitch;
  double      transverse_pitch = 0.; ///< distance of the middle planes of two strands; 0 of one
  double link_density_factor   = 1.; ///< of plates, bushes and pins over the density of all parts

  std::vector<std::string> derived; ///< sentences on values that no table and no entry gave

  /// Radial clearance between bush and roller.
  double roller_clearance() const { return 0.5 * (roller_bore - bush_diameter); }

  /// Radial clearance between pin and bush.
  double pin_clearance() const { return 0.5 * (bush_bore - pin_diameter); }

  /// Distance of the bush axes of an inner link: its hole pitch.
  double loaded_inner_pitch() const { return inner_hole_pitch; }

  /// Distance of the bush axes across an outer link whose pins are pulled against their bushes.
  double loaded_outer_pitch() const { return outer_hole_pitch + 2. * pin_clearance(); }

  /// Mean distance of consecutive rollers of the tight chain.
  double loaded_pitch() const { return 0.5 * (loaded_inner_pitch() + loaded_outer_pitch()); }
};

/// The chain that @p chain asks for: its own values first, then those of the standard's table, then
/// derived ones, each of which is stated in ChainDimensions::derived.
///
/// Hole pitches by pitch set, for the pitch p and the radial pin clearance c:
/// - standard: inner p, outer p - 2 c; a chain under load measures p from roller to roller;
/// - paper literal and nominal: inner p, outer p; under load p and p + 2 c alternate, p + c in the
///   mean.
///
/// Elongation lengthens both loaded pitches by the same factor. A joint whose clearance @p effects
/// switch off has a bore of the diameter of what turns in it, c = 0 and all pitches p.
///
/// @throws InputError for an unknown designation (names the nearest one and all others), a
/// clearance that is negative, a wall without thickness, a roller that does not fit between the
/// inner plates, plates that intersect.
ChainDimensions make_chain(const parameters::Chain   &chain,
                           const parameters::Effects &effects = parameters::Effects());

/// Whether rollers turn on the bushes of @p chain: as its entry says, else as the tables do of its
/// designation; true for an unknown one.
bool has_rollers(const parameters::Chain &chain);

/// Whether pitch, plates, pins, bushes or rollers of @p chain differ from those of its designation
/// alone, so that strength and mass of the tables are not its own.
bool has_own_dimensions(const ChainDimensions &chain);
} // namespace chaindrive::drive
