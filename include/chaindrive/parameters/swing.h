// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
class Declarations;

/// Section `Swing` of a wheel: its axis is on an arm that turns about a pivot as is prescribed, so
/// that distances between wheels change over time. Without a pivot it does not.
struct Swing
{
  std::optional<std::array<double, 2>> pivot = {}; ///< m
  std::vector<double>                  times;      ///< at which the arm has each of the angles, s
  std::vector<double>                  angles;     ///< rad, counter-clockwise as the drive turns
  std::string                          file = {};  ///< of a table in place of these; empty: none

  bool is_active() const { return pivot.has_value(); }

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};
} // namespace chaindrive::parameters
