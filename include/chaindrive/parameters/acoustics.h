// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace chaindrive::parameters
{
class Declarations;

/// Section `Acoustics`: what `chaindrive noise` computes of a run that has ended.
struct Acoustics
{
  bool noise = false; ///< whether a run computes it at its end

  std::vector<std::array<double, 3>> observers;              ///< m; empty: around the driver
  double                             radius = 0.4;           ///< of those around the driver, m
  std::optional<double>              floor;                  ///< y of a rigid one, m
  std::optional<double>              highest_frequency;      ///< Hz; auto: as the samples allow
  bool                               finite_rollers = false; ///< whether they are not compact
  double                             air_density    = 1.204; ///< kg/m3
  double                             speed_of_sound = 343.2; ///< m/s

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};
} // namespace chaindrive::parameters
