// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>

#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
// What chains may carry and how long they last, in closed form. doc/theory.md, section 9, says
// where each formula comes from, and which were written down from memory.

/// Ratings of the American Chain Association (Shigley's Mechanical Engineering Design, chapter 17):
/// power that link plates endure, power that rollers and bushes endure under their impacts, and the
/// speed at which joints begin to gall. They are regressions in inches, pounds and revolutions per
/// minute for the sizes 25 to 240; of other standards' chains of the same pitch they are a guide.
/// One strand, 15,000 hours, 100 links.
struct Ratings
{
  double pitch;             ///< inches
  double teeth, rpm;        ///< of the smaller sprocket
  double tension;           ///< pounds, effective
  bool   light, rollerless; ///< size 41; sizes 25 and 35

  double plates() const;  ///< W
  double rollers() const; ///< W
  double power() const;   ///< the lower one, W
  double speed() const;   ///< of the smaller sprocket at which joints gall, rpm
};

/// Of the chain @p designation with @p pitch [m].
Ratings
ratings_of(const std::string &designation, double pitch, double teeth, double rpm, double tension);

/// Hours that rollers and bushes endure the @p power [W] that is @p rating for 15,000 hours and 100
/// links: H is as (links / 100)^0.4 (15000 / hours)^0.4 (Shigley, chapter 17).
double hours_of_rollers(double rating, double power, double links);

/// How many times as much as one several strands carry, 1 to 6: Table 4.1 of Tsubaki's Complete
/// Guide to Chain, as B29.1.
double                        strand_factor(unsigned int strands);
inline constexpr unsigned int most_strands = 6;

/// What drives the driver.
enum class Motor
{
  electric,  ///< or turbine
  hydraulic, ///< combustion engine with a hydraulic drive
  engine     ///< combustion engine without one
};

/// How evenly the load pulls.
enum class Shock
{
  smooth,
  moderate,
  heavy
};

/// Factor on the power: Table 4.2 of Tsubaki's Complete Guide to Chain, as B29.1.
double service_factor(Motor motor, Shock shock);

/// How oil gets to the joints: types 1 to 4 of ISO 10823, and none.
enum class Lubrication
{
  none,
  manual,
  drip,
  bath,
  forced
};

/// The least that a chain of this @p pitch [m] takes at this @p speed [m/s]. Manual and bath up to
/// the speeds of ANSI B29.1 for the sizes 40 to 160, 300 to 100 and 2300 to 1000 ft/min,
/// interpolated as powers of the pitch; drip up to their geometric mean, which is an assumption.
Lubrication least_lubrication(double pitch, double speed);

/// Minimum dynamic strength [N] of ISO 606 for one strand: the force that a chain endures 3e6 times
/// from zero on. Of ANSI sizes that of the ISO size of the same dimensions; empty where it has
/// none.
std::optional<double> minimum_dynamic_strength(const std::string &designation);

/// The same of plates as in Annex C of ISO 606, F = 134.5 A p^(-0.0008 p), A = 2 t (0.99 h - d) in
/// mm: @p height h and @p thickness t of the inner plates, bush diameter d = d2 (d1 / d2)^0.475 of
/// rollers d1 and pins d2; all in m.
double dynamic_strength_of_plates(
    double pitch, double height, double thickness, double roller_diameter, double pin_diameter);
} // namespace chaindrive::drive

namespace chaindrive::parameters
{
template <>
inline constexpr Texts<drive::Motor, 3> texts_of<drive::Motor>{
    {{drive::Motor::electric, "electric"},
     {drive::Motor::hydraulic, "hydraulic"},
     {drive::Motor::engine, "engine"}}};

template <>
inline constexpr Texts<drive::Shock, 3> texts_of<drive::Shock>{
    {{drive::Shock::smooth, "smooth"},
     {drive::Shock::moderate, "moderate"},
     {drive::Shock::heavy, "heavy"}}};

template <>
inline constexpr Texts<drive::Lubrication, 5> texts_of<drive::Lubrication>{
    {{drive::Lubrication::none, "none"},
     {drive::Lubrication::manual, "manual"},
     {drive::Lubrication::drip, "drip"},
     {drive::Lubrication::bath, "bath"},
     {drive::Lubrication::forced, "forced"}}};
} // namespace chaindrive::parameters
