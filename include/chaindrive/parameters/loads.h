// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>

namespace chaindrive::parameters
{
/// Section `Loads`: what drives the system and what holds it back.
struct Loads
{
  double                driver_speed = 120.74; ///< rad/s, magnitude; the tight span sets the sense
  std::string           speed_ramp   = "linear";  ///< linear | cosine
  double                ramp_time    = 5e-3;      ///< s
  double                resisting_torque  = 150.; ///< N m, on the driven hub
  double                torque_ramp_angle = 0.03; ///< rad of driven rotation
  std::optional<double> torque_step_time;         ///< s after the start; empty: never
  double                torque_after_step = 0.;   ///< N m, below zero: it drives
  double                gravity           = 9.81; ///< m/s2, along -y
  double                drag = 0.; ///< 1/s, force = - drag * mass * velocity on chain bodies

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};

/// Section `Effects`: auto | on | off for each piece of physics that a scene may do without.
struct Effects
{
  std::string friction        = "auto"; ///< auto: on when a friction coefficient is not zero
  std::string contact_damping = "auto"; ///< auto: on when the damping ratio is not zero
  std::string chain_damping   = "auto"; ///< auto: on when the chain damping ratio is not zero
  std::string gravity         = "auto"; ///< auto: on when the acceleration is not zero
  std::string drag            = "auto"; ///< auto: on when the coefficient is not zero

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};
} // namespace chaindrive::parameters
