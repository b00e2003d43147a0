// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/life.h>
#include <chaindrive/drive/stiffness.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// Where the dynamic strength of a chain is from.
enum class StrengthFrom
{
  standard,   ///< ISO 606 lists it
  area,       ///< its Annex C has it of the plates' area
  hole_stress ///< the elastic stress at the plates' holes is hole_strength()
};

/// How long the chain of a drive lasts in steady running with the tensions of its Facts, in closed
/// form (doc/theory.md, section 9): without impacts and shocks, with the lubrication that its speed
/// asks for. Of several strands it is the one that pulls most. Hours may be endless. SI units
/// else.
struct DesignLife
{
  Lubrication lubrication; ///< the least that the speed asks for
  JointWear   joints;
  double      elongation; ///< at which the chain is replaced
  double      wear_rate;  ///< elongation per second
  double      wear_hours; ///< until then; known within a factor of wear_scatter
  double frame_hours; ///< the same in the frame of ISO 10823: 15,000 hours of 3 % at rated power

  double       dynamic_strength; ///< N
  StrengthFrom strength_from;
  double       newer_power;  ///< what newer editions of ASME B29.1 let plates of this strength
                             ///< carry, W; by a fit to their tables within 2 %, see
                             ///< doc/validation/worked-examples.md
  PlateFatigue plates;       ///< by that strength
  double       plate_safety; ///< endurance over the force from zero that does the same; 0: no force
  double       plate_hours;  ///< until plates fail, in the mean
  double       plate_early, plate_late; ///< of those two standard deviations weaker and stronger
  double       roller_hours;            ///< until rollers or bushes fail under their impacts

  double      capacity; ///< rated power of rollers and bushes over that of the drive; 0: no power
  double      tension;  ///< largest of a span, N
  PlateStress inner, outer;  ///< under that tension
  bool        holes_solved;  ///< whether stresses at holes are of elastic solutions
  PinStress   pin;           ///< under the same
  double      pressure;      ///< of the joints under the same, Pa
  double      galling_speed; ///< of the driver, above which joints gall, rad/s
};

/// What plates of this @p chain endure: the dynamic strength that ISO 606 lists; for plates that no
/// table knows that of the stress at their @p holes, or without it of the standard's Annex C.
PlateFatigue plate_fatigue(const ChainDimensions            &chain,
                           const std::optional<HoleFactors> &holes = {});

/// @p kept: the shafts cannot be moved when the chain wears. @p holes: of plates that are solved.
DesignLife design_life(const Facts                      &facts,
                       const ChainDimensions            &chain,
                       bool                              kept,
                       const std::optional<HoleFactors> &holes = {});

/// Member `life` of summary.json, and what it has: doc/output.md. Endless hours are null.
files::Json                   to_json(const DesignLife &life);
std::vector<files::Described> described_life();

/// The block of the plan.
void print(std::ostream &out, const DesignLife &life);

/// Hours in words: two digits, or "endless".
std::string in_hours(double hours);
} // namespace chaindrive::drive
