// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/plate.h>
#include <chaindrive/drive/stiffness_curve.h>
#include <chaindrive/material/material.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// Largest stress at the edge of the holes of side plates that a pin pulls, over the mean of the
/// section beside them: of elastic solutions.
struct HoleFactors
{
  double inner, outer;
};

/// Tooth and rim of a sprocket under a roller at one place of the seat.
struct PlacedStiffness
{
  double angle;     ///< from the bottom of the seat about its centre, rad
  double stiffness; ///< N/m
};

/// Over load and place, of the pairs of parts where that has been found.
struct StiffnessCurves
{
  std::optional<StiffnessCurve>              per_pitch, roller_bush;
  std::vector<std::optional<StiffnessCurve>> roller_tooth; ///< of each sprocket, or empty
};

/// What `auto` stands for: how the parts of a chain deflect, N/m, as force over approach.
struct PartStiffness
{
  double per_pitch;    ///< of the chain in a pull test
  double roller_tooth; ///< of a sprocket's hub and the roller's centre
  double roller_bush;  ///< of the roller's centre and the link's; without rollers infinite

  std::vector<double> teeth; ///< of each sprocket's tooth and rim alone; empty: not found

  std::optional<HoleFactors> holes; ///< where plates are solved

  std::vector<std::string> notes; ///< sentences for the log: where the values come from

  StiffnessCurves curves = {}; ///< where they are wanted: instead of the first three

  /// Of each sprocket, where they are wanted: at the bottom of the seat, between and where #teeth
  /// are; none of a drum.
  std::vector<std::vector<PlacedStiffness>> tooth_places = {};

  /// Of a sprocket's hub and the link: of a roller pressed between them.
  double pressed_roller() const
  {
    return std::isinf(roller_bush) ? roller_tooth :
                                     roller_tooth * roller_bush / (roller_tooth + roller_bush);
  }
};

// Estimates of stiffness from dimensions alone, N/m. A static solution of the elastic parts (room
// statics) is better where there is time for one.

/// All of them at @p load [N].
PartStiffness estimated_stiffness(const ChainDimensions &chain, double load, const Material &steel);

/// Two equal materials that touch along a line, pi/4 E* L with 1/E* = 2 (1 - nu^2)/E (Johnson,
/// Contact Mechanics, 4.2: nearly independent of the load).
double line_contact_stiffness(double length, const Material &steel);

/// A tooth of this @p width [m] without bending: the half-space of the above that is its material.
double tooth_stiffness(double width, const Material &steel);

/// Contact of a pin of radius R in a hole of radius R + clearance under the load per length q,
/// equal materials in plane strain without friction (Persson 1964; Ciavarella and Decuzzi 2001).
struct ConformingContact
{
  double half_angle;    ///< of the contact, rad
  double peak_pressure; ///< Pa
  double approach;      ///< of the two axes after touch, m
};

ConformingContact
conforming_contact(double radius, double clearance, double q, const Material &steel);

/// How stiff such a contact is in itself per area that touches, N/m3: load over approach, over the
/// length times 2 half_angle radius.
double contact_modulus(double radius, double clearance, double q, const Material &steel);

/// Pressure [Pa] over the projection of a joint, length times diameter, at which chains of the
/// standards break, or nearly so (525 at 510 MPa).
inline constexpr double breaking_pressure = 500e6;

/// That for which the step of contacts without penalty is meant, Pa: a quarter of the above, or
/// four times that under the tension @p load [N] if this is more. Chains in use bear a tenth.
double working_pressure(const ChainDimensions &chain, double load);

/// Up to which angle [rad] from the middle a cylinder of @p radius [m] touches a hole wider by
/// @p clearance [m] when it bears @p pressure [Pa] over its projection. Without clearance a right
/// angle.
double largest_half_angle(double radius, double clearance, double pressure, const Material &steel);

/// Modulus [N/m3] of a foundation in a seat wider than the roller of @p radius [m] by @p clearance
/// [m] that deflects by a force of @p stiffness [N/m] at @p load [N] on the @p length [m]: the
/// force over the mean of the deflection, weighted by the pressure of conforming contact.
double foundation_of_seat(double          radius,
                          double          clearance,
                          double          length,
                          double          load,
                          double          stiffness,
                          const Material &steel);

/// Secant stiffness, load over approach, at @p load [N].
double roller_bush_stiffness(const ChainDimensions &chain, double load, const Material &steel);
double bush_pin_stiffness(const ChainDimensions &chain, double load, const Material &steel);

/// One plate pulled at its holes by pins that press on the far halves of the holes.
double plate_stiffness(const Plate &plate, const Material &steel);

/// One plate clamped at its holes and pressed across its plane in the middle, as a beam with the
/// section of its waist: 192 E I / p^3, I = h t^3 / 12 (Timoshenko, Strength of Materials I).
double plate_side_stiffness(const Plate &plate, const Material &steel);

/// The chain per pitch: the plates of an inner link, those of an outer link and two bush-pin
/// joints at the load @p load [N], all in series, are two pitches.
double chain_stiffness(const ChainDimensions &chain, double load, const Material &steel);
} // namespace chaindrive::drive
