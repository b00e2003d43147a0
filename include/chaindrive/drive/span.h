// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace chaindrive::drive
{
/// The chain between and on two sprockets that turn counter-clockwise, the upper span tight: which
/// joints sit where. Joint 0 enters the driver; link k joins joints k and k + 1; links of even
/// number are inner links. Lengths in m, angles in rad.

/// Distances of consecutive bushes.
struct LinkLengths
{
  double inner, outer;

  double of(const unsigned int link) const { return link % 2 == 0 ? inner : outer; }

  /// Length of @p n links, the first of which is number @p first.
  double sum(unsigned int first, unsigned int n) const;
};

/// A sprocket with the bushes of a chain wrapped around it: bush k of a seat at the polar angle g
/// is at g + shift for even k, g - shift for odd k, on the circle of radius bush_radius, so that
/// consecutive bushes have exactly the distances of inner and outer links.
struct Wheel
{
  unsigned int     teeth;
  dealii::Point<2> centre;
  double           pitch_angle;
  double           roller_radius; ///< of the circle of the seats, p / (2 sin(pi/z)), p mean length
  double           bush_radius;
  double           shift;

  Wheel(unsigned int n_teeth, const dealii::Point<2> &position, const LinkLengths &lengths);

  dealii::Point<2> roller(double seat) const;
  dealii::Point<2> bush(double seat, unsigned int joint) const;
};

/// Polar angle of the outward normal of the upper common tangent of the two seat circles.
double tangent_angle(const Wheel &driver, const Wheel &driven);

/// A straight span from the last seat on the driven sprocket to the first one on the driver.
struct TightSpan
{
  double           entry, exit; ///< polar angles of the seats on driver and driven
  unsigned int     links;
  dealii::Point<2> from, to; ///< bushes, in the direction of travel
  double           misfit;   ///< see below
};

/// Slack span, from the last seat on the driver to the first one on the driven sprocket: a polygon
/// whose links turn by the same angle from one to the next.
struct SlackSpan
{
  int              driver_links, driven_links; ///< on the sprockets
  int              links;
  dealii::Point<2> from, to; ///< bushes, in the direction of travel
  double           slack;    ///< length of the links less the distance from end to end
  double           turn;     ///< from link to link, positive to the left; 0 for a straight span
  double           heading;  ///< direction angle of its first link
  double           leaving, arriving; ///< by what the chain turns at its two ends
  double           misfit;
};

/// At a sprocket the chain turns by an angle between zero (a roller has just seated or is about to
/// leave) and the pitch angle. The misfit is the sum of what lies outside of that range; among all
/// spans one has none, but for round-off.

/// The tight span whose entry seat is at the polar angle @p entry and that has @p links links; zero
/// links in the result if it does not reach.
TightSpan tight_span(const Wheel       &driver,
                     const Wheel       &driven,
                     const LinkLengths &lengths,
                     unsigned int       n_joints,
                     double             entry,
                     unsigned int       links);

/// Tight spans near the tangent, the best first. @p phase of a driver pitch: 0 where the entry seat
/// is half a pitch angle before the tangent point.
std::vector<TightSpan> tight_spans(const Wheel       &driver,
                                   const Wheel       &driven,
                                   const LinkLengths &lengths,
                                   unsigned int       n_joints,
                                   double             phase);

/// The slack span that leaves these numbers of links on the sprockets.
/// @param bulge  +1: away from the tight span, -1: towards it, 0: the span is taken as straight
SlackSpan slack_span(const Wheel       &driver,
                     const Wheel       &driven,
                     const LinkLengths &lengths,
                     unsigned int       n_joints,
                     const TightSpan   &tight,
                     int                bulge,
                     int                driver_links,
                     int                driven_links);

/// The slack span of least misfit and its neighbours, the best first.
std::vector<SlackSpan> slack_spans(const Wheel       &driver,
                                   const Wheel       &driven,
                                   const LinkLengths &lengths,
                                   unsigned int       n_joints,
                                   const TightSpan   &tight,
                                   int                bulge);

/// Bushes of the slack span between its ends.
std::vector<dealii::Point<2>> slack_joints(const SlackSpan &span, const LinkLengths &lengths);
} // namespace chaindrive::drive
