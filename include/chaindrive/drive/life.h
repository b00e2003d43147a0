// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/ratings.h>

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace chaindrive::drive
{
inline constexpr double endless = std::numeric_limits<double>::infinity(); ///< hours

/// Wear of the joints by Archard's law: depth = k times the integral of pressure over sliding
/// distance. k [1/Pa] is that of hardened steel with all the oil that least_lubrication() asks for.
/// It makes chains of the standards reach 3 % after 15,000 hours under about their highest rating,
/// as ISO 10823 has it, and is known within a factor of wear_scatter.
inline constexpr double wear_coefficient = 1e-16, wear_scatter = 3.;

/// By how much faster joints wear with @p given than with @p least, at this chain speed [m/s]: the
/// reciprocal of the lubrication factors of DIN 8195, 0.6 up to 4 m/s and 0.3 above for too little
/// oil, 0.15 for none.
double wear_factor(Lubrication given, Lubrication least, double speed);

/// How fast the joints of a chain wear. A joint turns by 2 pi / z where it enters and where it
/// leaves a sprocket of z teeth, under the tension of the span beside it.
struct JointWear
{
  double pitch, pin_diameter; ///< m
  double bearing_area;        ///< of a joint, m2
  double links;               ///< of the chain

  /// Elongation per second: @p force_angle is the sum of tension times angle over the places where
  /// a joint turns [N rad], @p pitches how many pass in a second.
  double rate(double force_angle, double pitches, double coefficient = wear_coefficient) const;

  /// The same from the friction @p power [W] of all its joints with the coefficient of friction @p
  /// mu.
  double rate_of_losses(double power, double mu, double coefficient = wear_coefficient) const;
};

/// At which elongation a chain is replaced: 3 %, 200 % / z of the larger sprocket, or half of the
/// former where shafts are @p kept.
double most_elongation(unsigned int largest_teeth, bool kept = false);

/// Hours until @p elongation in the frame of ISO 10823, in which a chain of 120 links has 3 % after
/// 15,000 hours at its rated power: @p capacity is that over the power.
double frame_hours(double capacity, double elongation, double links);

/// Slope of the S-N line of link plates.
inline constexpr double plate_exponent = 10.;

/// The S-N line of link plates: 3e6 times the minimum dynamic strength from zero, slope 10 as that
/// of the rating, which falls as speed^0.1, down to 1e7 cycles, below which they do not fail.
/// Forces that do not begin at zero are reduced to that by Goodman's line, as Annex D of ISO 606
/// does.
struct PlateFatigue
{
  double dynamic_strength, tensile_strength; ///< N; the latter 0: unknown, no mean force effect

  /// The force from zero that does the same damage as one between @p least and @p most.
  double from_zero(double least, double most) const;

  /// Cycles to failure; endless below the limit.
  double cycles(double least, double most) const;

  /// Force that is endured endlessly, from zero.
  double endurance() const;

  /// Plates that are weaker than these by the standard deviation of their strength, so many times.
  PlateFatigue weaker(double deviations) const;
};

/// Standard deviation of the dynamic strength of plates over its mean.
inline constexpr double plate_scatter = 0.05;

/// A cycle of a history: range, mean, and how often it is counted, 0.5 or 1.
struct Cycle
{
  double range, mean, count;
};

/// Adds @p value to a history of which @p points are the turning points so far and the last value.
void add_turning_point(std::vector<double> &points, double value);

/// Rainflow cycles of a @p history in the order in which they close, then those that do not: ASTM
/// E1049-85, 5.4.4. Values between turning points do not matter.
std::vector<Cycle> rainflow(const std::vector<double> &history);

/// Cycles of a @p turn that repeats, all of which close: it is counted from its largest value on,
/// as ASTM E1049-85, 5.4.5, does.
std::vector<Cycle> rainflow_of_turn(const std::vector<double> &turn);

/// Turns of the chain until the plates fail by the cycles of one turn (Palmgren and Miner).
double turns_of(const PlateFatigue &plates, const std::vector<Cycle> &cycles);

/// Nominal and peak stress [Pa] of a plate under its share of the tension, half of it.
struct PlateStress
{
  double waist; ///< mean over the section at mid-pitch
  double net;   ///< mean over the section beside the hole
  double hole;  ///< largest at its edge: net times the factor, without press fit
};

/// The @p factor of the hole is that of an elastic solution, or without one that of a closely
/// fitting pin in a long straight plate (Frocht and Hill 1940; Pilkey, Peterson's Stress
/// Concentration Factors, lugs), which for plates of chains is two thirds of it.
PlateStress plate_stress(double                tension,
                         double                height,
                         double                waist_height,
                         double                hole,
                         double                thickness,
                         std::optional<double> factor = {});

/// Range of the elastic stress at the edge of the hole, from zero, that plates endure 3e6 times:
/// what the minimum dynamic strengths of ISO 606 are at the plate that has more of it, with the
/// factors of elastic solutions. It falls with the pitch [m] as the standard's Annex C does. The
/// strengths of series A from 08A on are within 4 % of it (test statics/lug).
double hole_strength(double pitch);

/// Exponent of the life of rollers and bushes: (15000 / hours)^0.4 of the rating.
inline constexpr double roller_exponent = 2.5;

/// Force [N] between the first roller on a sprocket of so many @p teeth and its tooth under a
/// @p tension [N] of the span before it, without impact: F sin(2 pi / z) / sin(2 pi / z + phi),
/// phi = 35 - 120 / z degrees (Binder, Mechanics of the Roller Chain Drive, 1956).
double seat_force(double tension, double teeth);

/// Hours that rollers and bushes endure impacts with @p peaks [N]. The drive with the rated power
/// of the ANSI equation endures its own for 15,000 hours and 100 links. These are the same but that
/// the force of a roller without impact is that of its power: @p seat [N] is that force here, @p
/// capacity the rated power over that of the drive. Peaks of different size do damage as their
/// power roller_exponent. Never better than by the powers alone. Endless without peaks.
struct PeakLife
{
  double peak;  ///< that does the damage of them all, N
  double rated; ///< mean peak at the rated power, N
  double hours;
};
PeakLife
life_of_peaks(const std::vector<double> &peaks, double seat, double capacity, double links);

/// Stress of a solid or hollow pin [Pa] that the outer plates hold at the distance @p length of
/// their middles, and whose bush presses evenly on @p bush_length.
struct PinStress
{
  double bending, shear; ///< largest; mean over the section
};
PinStress
pin_stress(double tension, double diameter, double bore, double length, double bush_length);
} // namespace chaindrive::drive
