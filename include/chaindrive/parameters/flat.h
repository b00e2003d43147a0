// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>

#include <optional>

namespace chaindrive::parameters
{
class Declarations;

/// With what a chain lies on a wheel without teeth.
enum class RunsOn
{
  rollers, ///< they roll on it, between the plates
  plates   ///< their edges lie on it
};

template <>
inline constexpr Texts<RunsOn, 2> texts_of<RunsOn>{
    {{RunsOn::rollers, "rollers"}, {RunsOn::plates, "plates"}}};

/// Section `Flat` of a wheel: one without teeth.
struct Flat
{
  std::optional<double> diameter  = {}; ///< m; empty: the wheel has teeth
  RunsOn                runs_on   = RunsOn::rollers;
  std::optional<double> friction  = {}; ///< empty: that of rollers on teeth
  std::optional<double> stiffness = {}; ///< under one joint, N/m; empty: as of a tooth

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};
} // namespace chaindrive::parameters
