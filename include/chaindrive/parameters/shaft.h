// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

namespace chaindrive::parameters
{
class Declarations;

/// Section `Coupling` of a wheel: a torsion spring with a damper between the sprocket and what is
/// behind it, the motor of a driver or the inertia of a machine.
struct Coupling
{
  std::optional<double> stiffness     = {};   ///< N m/rad; empty: rigid
  std::optional<double> damping       = {};   ///< N m s/rad; empty: from the ratio
  double                damping_ratio = 0.05; ///< of sprocket and machine on the spring
  std::optional<double> sprocket      = {};   ///< inertia before it, kg m2; empty: the solid's

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};

/// Section `Bearing` of a wheel: springs with dampers along x and y that hold its shaft.
struct Bearing
{
  std::optional<double> stiffness         = {};   ///< N/m; empty: rigid
  std::optional<double> stiffness_along_y = {};   ///< N/m; empty: the same
  std::optional<double> damping           = {};   ///< N s/m; empty: from the ratio
  double                damping_ratio     = 0.05; ///< of the mass on the spring
  std::optional<double> mass              = {};   ///< that moves, kg; empty: the solid's

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};
} // namespace chaindrive::parameters
