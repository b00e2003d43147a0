// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/path/span.h>

#include <optional>
#include <vector>

namespace chaindrive::path
{
/// A closed chain that is to be laid round wheels, which it meets in the order of travel. Span 0
/// leads from wheel 0 to wheel 1 and has all the slack; the others are straight, the last of them
/// back to wheel 0, where joint 0 enters.
struct Chain
{
  unsigned int n_links;
  LinkLengths  seats, taut, slack; ///< on the wheels, in straight spans and in span 0
  double       phase; ///< 0 to 1: how far joint 0 has come on wheel 0, see entries_near_tangent()
  int          bulge; ///< of span 0, see slack_span()
};

/// All that is discrete in a laid chain.
struct Route
{
  int                       gap; ///< of joint 0's seat, counted from the one that the phase prefers
  std::vector<unsigned int> spans; ///< links in each; of span 0 what is left
  std::vector<int>          wraps; ///< links on each wheel
};

/// A chain that is laid.
struct Laid
{
  Route                 route;
  std::vector<double>   entry; ///< polar angle of the first seat on each wheel
  std::vector<TautSpan> taut;  ///< spans 1, 2, ...
  SlackSpan             slack; ///< span 0
  double                misfit = 0.;

  /// The straight span that enters wheel 0.
  const TautSpan &last() const { return taut.back(); }
};

/// A joint of a laid chain.
struct Joint
{
  dealii::Point<2> roller, bush; ///< centres
  int              wheel;        ///< on which it sits, -1 in a span
  int              seat;         ///< counted from the wheel's first; -1 in a span
};

/// Ways to lay @p chain round at least two @p wheels, the best first; none where two wheels that
/// follow each other have no common tangent. @p straight: with a straight span 0, which makes the
/// slack of the best route a continuous function of where the wheels are. Only the @p most best
/// spans that enter wheel 0 count.
std::vector<Laid>
lay_all(const std::vector<Wheel> &wheels, const Chain &chain, bool straight, unsigned int most);

/// The chain on that route; nothing if it cannot be.
std::optional<Laid> lay(const std::vector<Wheel> &wheels, const Chain &chain, const Route &route);

/// All joints of a chain that is laid, in the direction of travel: those on wheel 0, in span 0, on
/// wheel 1 and so on. A span has one joint less than links, since its ends sit on wheels.
std::vector<Joint> joints(const std::vector<Wheel> &wheels, const Chain &chain, const Laid &laid);
} // namespace chaindrive::path
