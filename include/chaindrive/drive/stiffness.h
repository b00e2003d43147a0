// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/plate.h>
#include <chaindrive/material/material.h>

namespace chaindrive::drive
{
/// Estimates of stiffness from dimensions alone, N/m: what `auto` stands for. A static solution of
/// the elastic parts is better where there is one.

/// A ring pressed together by two opposite forces, E I / (0.1488 R^3) with the mean radius R (thin
/// ring in bending; Roark's Formulas for Stress and Strain, circular rings, case 1).
double ring_stiffness(double outer_diameter, double bore, double length, const Material &steel);

/// Two equal materials that touch along a line, pi/4 E* L with 1/E* = 2 (1 - nu^2)/E (Johnson,
/// Contact Mechanics, 4.2: nearly independent of the load).
double line_contact_stiffness(double length, const Material &steel);

/// A roller on a tooth: its ring and the line contact in series.
double roller_tooth_stiffness(const ChainDimensions &chain, const Material &steel);

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

/// Secant stiffness, load over approach, at @p load [N].
double roller_bush_stiffness(const ChainDimensions &chain, double load, const Material &steel);
double bush_pin_stiffness(const ChainDimensions &chain, double load, const Material &steel);

/// One plate pulled at its holes by pins that press on the far halves of the holes.
double plate_stiffness(const Plate &plate, const Material &steel);

/// The chain per pitch: the plates of an inner link, those of an outer link and two bush-pin
/// joints at the load @p load [N], all in series, are two pitches.
double chain_stiffness(const ChainDimensions &chain, double load, const Material &steel);
} // namespace chaindrive::drive
