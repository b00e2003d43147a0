// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/path/wheel.h>

#include <vector>

namespace chaindrive::path
{
/// Polar angle of the normal, to the right of travel, of the straight line on which a chain runs
/// from the circle of seats of one wheel to that of the next. It touches each at this angle, or on
/// the other side where the wheel turns clockwise: see touching(). Not a number where there is no
/// such line.
double tangent_angle(const Wheel &from, const Wheel &to);

/// How far the mean of @p points is to the right of that line, m.
double beside(const Wheel &from, const Wheel &to, const std::vector<dealii::Point<2>> &points);

/// Polar angle, on @p wheel, of the point where a line touches with the normal @p tangent.
double touching(const Wheel &wheel, double tangent);

/// At a wheel the chain turns by an angle between zero (a roller has just seated or is about to
/// leave) and the pitch angle. The misfit of a span is the sum of what lies outside of that range
/// at its two ends; among all spans one has none, but for round-off.

/// A straight span, from the last seat on a wheel to the first one on the next.
struct TautSpan
{
  double           exit, entry; ///< polar angles of the seats that it joins
  unsigned int     links;       ///< 0: there is none
  dealii::Point<2> from, to;    ///< bushes, in the direction of travel
  double           misfit;
};

/// The span of @p links links that enters wheel @p to with joint @p joint in the seat at @p entry;
/// zero links in the result if it does not reach. @p joint is at least @p links.
TautSpan taut_span(const Wheel       &from,
                   const Wheel       &to,
                   const LinkLengths &lengths,
                   unsigned int       joint,
                   double             entry,
                   unsigned int       links);

/// Those whose entry seat is one of @p entries, the best first.
std::vector<TautSpan> taut_spans(const Wheel               &from,
                                 const Wheel               &to,
                                 const LinkLengths         &lengths,
                                 unsigned int               joint,
                                 const std::vector<double> &entries);

/// The entry seats near the tangent from wheel @p from to wheel @p to. @p phase of a pitch angle: 0
/// where the seat is half a pitch angle before the point where the tangent touches.
std::vector<double> entries_near_tangent(const Wheel &from, const Wheel &to, double phase);

/// Links on @p wheel from the polar angle @p from to @p to, in the direction of travel, to the
/// nearest number. An angle that goes back by up to an eighth of a turn holds none.
int links_on(const Wheel &wheel, double from, double to);

/// The span with all the slack: a polygon whose links turn by the same angle from one to the next.
struct SlackSpan
{
  int              links_before, links_after; ///< on the wheels at its two ends
  int              links;
  dealii::Point<2> from, to; ///< bushes, in the direction of travel
  double           slack;    ///< length of the links less the distance from end to end
  double           turn;     ///< from link to link, positive to the left; 0 for a straight span
  double           heading;  ///< direction angle of its first link
  double           leaving, arriving; ///< by what the chain turns at its two ends
  double           misfit;

  /// Greatest distance of the polygon's circle from its chord, m.
  double sag() const;
};

/// What a slack span closes: the chain between the entry seat of the wheel before it, at the polar
/// angle @p entry with joint 0 in it, and the last seat of the wheel after it, at @p exit: @p links
/// links, of which the span is what the wheels leave.
struct Gap
{
  const Wheel &before, &after;
  double       entry, exit;
  unsigned int links;
};

/// The slack span that leaves these numbers of links on the wheels at its ends.
/// @param bulge  +1: its links turn to the left, -1: to the right, 0: the span is taken as straight
SlackSpan slack_span(
    const Gap &gap, const LinkLengths &lengths, int bulge, int links_before, int links_after);

/// The slack span of least misfit and its neighbours, the best first.
std::vector<SlackSpan> slack_spans(const Gap &gap, const LinkLengths &lengths, int bulge);

/// Bushes of the slack span between its ends.
std::vector<dealii::Point<2>> slack_joints(const SlackSpan &span, const LinkLengths &lengths);
} // namespace chaindrive::path
