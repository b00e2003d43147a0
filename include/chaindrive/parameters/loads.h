// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>

#include <optional>

namespace chaindrive::parameters
{
class Declarations;
struct Sprockets;

/// How the driver's speed grows from zero.
enum class SpeedRamp
{
  linear,
  cosine
};

template <>
inline constexpr Texts<SpeedRamp, 2> texts_of<SpeedRamp>{
    {{SpeedRamp::linear, "linear"}, {SpeedRamp::cosine, "cosine"}}};

/// Section `Loads`: what drives the system and what holds it back.
struct Loads
{
  double                driver_speed = 120.74; ///< rad/s, magnitude; the tight span sets the sense
  SpeedRamp             speed_ramp   = SpeedRamp::linear;
  double                ramp_time    = 5e-3;      ///< s
  double                resisting_torque  = 150.; ///< N m, on the driven hub
  double                torque_ramp_angle = 0.03; ///< rad of driven rotation
  std::optional<double> torque_step_time;         ///< s after the start; empty: never
  double                torque_after_step = 0.;   ///< N m, below zero: it drives
  double                gravity           = 9.81; ///< m/s2, along -y
  double                drag = 0.; ///< 1/s, force = - drag * mass * velocity on chain bodies

  /// Declares an entry for each member, and those of the terms of speed and torque of each of @p
  /// sprockets, which takes every value that is set. The objects must outlive @p declarations.
  void declare(Declarations &declarations, Sprockets &sprockets);
};

/// Section `Effects`: a switch for each piece of physics that a scene may do without. Whether
/// sprockets are elastic stands with each of them (Sprocket::elastic).
struct Effects
{
  Switch friction = Switch::automatic; ///< automatic: on when a friction coefficient is not zero
  Switch contact_damping = Switch::automatic; ///< automatic: on when the damping ratio is not zero
  Switch chain_damping =
      Switch::automatic;               ///< automatic: on when the chain damping ratio is not zero
  Switch gravity  = Switch::automatic; ///< automatic: on when the acceleration is not zero
  Switch drag     = Switch::automatic; ///< automatic: on when the coefficient is not zero
  Switch oil_film = Switch::automatic; ///< automatic: on when the viscosity is not zero
  Switch roller_bush_clearance = Switch::automatic; ///< automatic: on in models that have joints
  Switch bush_pin_clearance    = Switch::automatic;
  Switch elastic_links    = Switch::automatic; ///< of these automatic: on where what is asked for
  Switch elastic_rollers  = Switch::automatic; ///< needs them, see model/needs.h
  Switch plate_bending    = Switch::automatic; ///< automatic: on in elastic links
  Switch tooth_compliance = Switch::automatic; ///< automatic: on under reduced rollers
  Switch tooth_places     = Switch::automatic; ///< automatic: on where they are known
  Switch tooth_inertia    = Switch::automatic; ///< automatic: off
  Switch planar_motion    = Switch::automatic; ///< automatic: on where nothing leaves the plane
  Switch separate_strands = Switch::automatic; ///< automatic: on where wheels are out of line
  Switch oval_rollers     = Switch::automatic; ///< automatic: off
  Switch stiffness_curves = Switch::automatic; ///< automatic: on where they are known

  /// Declares an entry for each member and for Sprocket::elastic of each of @p sprockets, which
  /// takes every value that is set. The objects must outlive @p declarations.
  void declare(Declarations &declarations, Sprockets &sprockets);
};
} // namespace chaindrive::parameters
