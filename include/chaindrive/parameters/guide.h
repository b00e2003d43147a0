// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>
#include <chaindrive/parameters/tensioner.h>

#include <array>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
class Declarations;

/// The line through the points of a guide.
enum class GuideLine
{
  arc,   ///< the circle through three points
  spline ///< the natural cubic spline
};

template <>
inline constexpr Texts<GuideLine, 2> texts_of<GuideLine>{
    {{GuideLine::arc, "arc"}, {GuideLine::spline, "spline"}}};

/// Section `Guide` of a wheel: of the span that leads from it to the next one.
struct Guide
{
  Guide(); ///< not inline, for g++ 12 then believes that its points are not initialised

  std::vector<std::array<double, 2>> points; ///< m; none: there is no guide
  GuideLine                          line      = GuideLine::arc;
  double                             friction  = 0.1; ///< of plates on it
  double                             stiffness = 1e7; ///< under the plates of one joint, N/m
  Holders                            held{};          ///< what it is on; bearing: it stands still

  /// Whether a spring presses it against the chain.
  bool is_sprung() const { return !points.empty() && parameters::is_sprung(held.holder); }

  /// Declares an entry for each member, which takes every value that is set; what it is on only
  /// where it @p may_move. The object must outlive @p declarations.
  void declare(Declarations &declarations, bool may_move);
};
} // namespace chaindrive::parameters
