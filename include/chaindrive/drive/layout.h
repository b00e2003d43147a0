// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/drive.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace chaindrive::drive
{
/// Where everything is at the start: the driver's axis at the origin, the driven one's at
/// (centre_distance, 0). Upper span tight: both sprockets turn counter-clockwise. Lower span tight:
/// the mirror image, both turn clockwise. SI units.
struct Layout
{
  /// What a joint is part of. A joint on a sprocket sits in one of its gaps.
  enum class Region
  {
    driver,
    slack,
    driven,
    tight
  };

  struct Joint
  {
    dealii::Point<2>     roller;   ///< centre
    dealii::Point<2>     bush;     ///< centre
    dealii::Tensor<1, 2> velocity; ///< zero unless the start is warm
    Region               region;
    int                  tooth_gap; ///< of the sprocket it sits in, -1 in a span
  };

  /// The link from joint k to joint k + 1. Inner links have even numbers.
  struct Link
  {
    dealii::Point<2> centre; ///< midway between its bushes
    double           angle;  ///< of the direction from joint k to joint k + 1, rad
    bool             inner;
  };

  double centre_distance;
  int    sense;        ///< +1: counter-clockwise, -1: clockwise
  double driver_angle; ///< of gap 0 from +x, rad
  double driven_angle;
  double driver_speed; ///< rad/s, counter-clockwise positive; zero unless the start is warm
  double driven_speed;

  std::vector<Joint> joints; ///< in the direction of travel; joint 0 enters the driver
  std::vector<Link>  links;

  double slack; ///< length of the slack span's links less the distance that they bridge, m
  double sag;   ///< of the slack span from the straight line between its ends, m

  unsigned int tight_links, slack_links;   ///< in the spans
  unsigned int driver_seats, driven_seats; ///< joints on the sprockets

  dealii::Tensor<1, 2> tight_direction; ///< unit, of travel of the tight span
  dealii::Tensor<1, 2> tight_normal;    ///< unit, outward
};

/// Lays the chain on the sprockets.
///
/// Rollers on a sprocket are on the circle of radius p / (2 sin(pi/z)), p the loaded pitch, in the
/// middle of their gaps. The tight span is straight. The slack span is a polygon with equal angles
/// between its links that bulges along gravity (-y), or outwards where there is none.
///
/// @param clearances  false: the simple model, one lump per joint, all links of the loaded mean
/// pitch.
///   true: distances of bushes are exactly the chain's loaded pitches (in the spans, for start
///   `concentric`, its hole pitches), inner and outer alternating; bush and roller are concentric
///   in the spans, and on the sprockets where both loaded pitches are equal.
/// @param stiffness_per_pitch  of the chain, N/m: turns pre-tension into stretch. With clearances
/// all
///   stretch is in the outer links, whose joints carry the compliance.
/// @param driver_speed   magnitude, rad/s, for start `warm`
/// @param tight_tension  N, for start `warm`
/// @param weightless     no gravity acts
///
/// @throws InputError when the chain does not fit (states what would), when a roller overlaps a
/// tooth or a bush its roller (states where and by how much), for an odd number of links with
/// clearances, or sprockets that overlap.
Layout make_layout(const parameters::Drive &drive,
                   const ChainDimensions   &chain,
                   const ToothForm         &driver,
                   const ToothForm         &driven,
                   bool                     clearances,
                   double                   stiffness_per_pitch,
                   double                   driver_speed,
                   double                   tight_tension,
                   bool                     weightless = false);

/// Centre and direction of every link of @p layout from the bushes of its two joints.
void set_links(Layout &layout);
} // namespace chaindrive::drive
