// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/tensioner.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/drive.h>
#include <chaindrive/path/route.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

namespace chaindrive::drive
{
/// Where everything is at the start. The chain's path leads round the sprockets in turn: span i
/// leads from sprocket i to the next one, the last span back to sprocket 0.
///
/// Sprocket 0 is the driver. Without a centre of its own its axis is at the origin, and that of
/// another one at (centre distance, 0). Upper span tight: the drive turns counter-clockwise. Lower
/// span tight: the mirror image, clockwise. SI units.
struct Layout
{
  struct Sprocket
  {
    dealii::Point<2> centre; ///< of its pitch circle
    double           angle;  ///< of gap 0 from +x, rad
    double           speed; ///< rad/s, counter-clockwise positive; zero unless the start is settled
    unsigned int     seats; ///< joints that sit on it
    int              turn;  ///< +1: the chain runs round it in the sense of the drive, -1: against

    dealii::Tensor<1, 2> eccentricity = {}; ///< of the centre from the axis of its shaft, m

    dealii::Tensor<1, 2> deflection = {}; ///< of its axis in the bearing, m
    double               torque = 0.; ///< that its shaft gives to it, counter-clockwise, N m; zero
                                      ///< unless the start is settled

    dealii::Point<2> axis() const { return centre - eccentricity; }

    /// Where its axis is while nothing pulls at it.
    dealii::Point<2> unloaded() const { return axis() - deflection; }
  };

  struct Span
  {
    bool         straight; ///< at the start, but for what has settled
    unsigned int first;    ///< joint at which it begins: the last seat of the sprocket before it
    unsigned int links;
    double       slack;             ///< length of its links less the distance that they bridge, m
    double       sag;               ///< from the straight line between its ends, m; settled if so
    dealii::Tensor<1, 2> direction; ///< unit, of travel
    dealii::Tensor<1, 2> normal;    ///< unit, outward
  };

  struct Joint
  {
    dealii::Point<2>     roller;          ///< centre
    dealii::Point<2>     bush;            ///< centre
    dealii::Tensor<1, 2> velocity;        ///< zero unless the start is settled
    int                  sprocket;        ///< it sits on, -1 in a span
    int                  tooth_gap;       ///< of the sprocket it sits in, -1 in a span
    double               pin_force  = 0.; ///< for which pin and bush are placed, N
    double               seat_force = 0.; ///< for which roller and tooth are placed, N
  };

  /// The link from joint k to joint k + 1. Inner links have even numbers.
  struct Link
  {
    dealii::Point<2> centre;
    double           angle; ///< of the direction from joint k to joint k + 1, rad
    bool             inner;
    double           ahead = 0.; ///< of the middle between its bushes, by JointShifts, m
  };

  int                   sense; ///< +1: counter-clockwise, -1: clockwise
  std::vector<Sprocket> sprockets;
  std::vector<Span>     spans;
  std::vector<Joint>    joints; ///< in the direction of travel; joint 0 enters sprocket 0
  std::vector<Link>     links;
  double                prestress = 0.; ///< largest force that joints and teeth are placed for, N

  std::optional<Tensioner> tensioner = {}; ///< with a spring, where it is at the start
  std::optional<Tensioner> clamped   = {}; ///< the place of a wheel that has been found so

  /// The span that leads to a sprocket; span i leads from sprocket i.
  const Span &into(unsigned int sprocket) const;

  /// While the driver drives, the span that it pulls in is the tightest one, and the one that it
  /// lets out has all the slack.
  const Span &tight() const { return into(0); }
  const Span &slack() const { return spans.front(); }

  unsigned int moved = 1;     ///< the sprocket whose distance from sprocket 0 the layout decides
  bool         rises = false; ///< the chain gets slack as it goes away from sprocket 0

  /// Of these two while nothing pulls at them, m.
  double centre_distance() const
  {
    return sprockets[0].unloaded().distance(sprockets[moved].unloaded());
  }
};

/// By how much further the surfaces of single joints must come together than those of all others
/// for the same force, m: of elastic bodies, whose stiffness is their own. Empty: nothing.
struct JointShifts
{
  std::vector<double> pin;  ///< of a pin in its bush
  std::vector<double> seat; ///< of a bush on a tooth, through its roller

  double pin_of(const unsigned int k) const { return pin.empty() ? 0. : pin[k]; }
  double seat_of(const unsigned int k) const { return seat.empty() ? 0. : seat[k]; }
};

/// What joints and wheels of a laid chain are in a layout: wheels in their order, span 0 the slack
/// one, nothing in motion. Frames of wheels begin at the tooth gap of their first seat.
Layout
to_layout(const std::vector<path::Wheel> &wheels, const path::Chain &chain, const path::Laid &laid);

/// Whether the sag of @p layout is that of the drive in operation: the start is settled.
bool keeps_sag(const parameters::Layout &layout);

/// Lays the chain on the sprockets.
///
/// Rollers on a sprocket are on the circle of radius p / (2 sin(pi/z)), p the loaded pitch, in the
/// middle of their gaps. The tight span is straight. The slack span is a polygon with equal angles
/// between its links that bulges along gravity (-y), or outwards where there is none. A tensioner
/// with a spring is where all spans are straight, or at its greatest travel, one that is clamped
/// where the slack span is as it should be.
///
/// @param forms  of the sprockets, in the order of the path: driver and driven sprocket
/// @param clearances  Without them, in the simple model, a joint is one lump and all links have the
/// loaded mean pitch. With them distances of bushes are exactly the chain's loaded pitches (in the
/// spans, for start `concentric`, its hole pitches), inner and outer alternating; bush and roller
/// are concentric in the spans, and on the sprockets where both loaded pitches are equal.
/// @param stiffness_per_pitch  Of the chain, N/m: it turns pre-tension into stretch. With
/// clearances all stretch is in the outer links, whose joints carry the compliance.
/// @param driver_speed   magnitude, rad/s, for start `settled`
/// @param tight_tension  N, for start `settled`
/// @param weightless     no gravity acts
/// @param weight, centrifugal  Per metre of chain, N/m, and the tension that turns it, N. For start
/// `settled` with a given sag both spans are stretched by the centrifugal tension and by the one
/// that the weight makes of this sag.
///
/// @throws InputError when the chain does not fit (states what would), when a roller overlaps a
/// tooth or a bush its roller (states where and by how much), for an odd number of links with
/// clearances, or sprockets that overlap.
Layout make_layout(const parameters::Drive      &drive,
                   const ChainDimensions        &chain,
                   const std::vector<ToothForm> &forms,
                   bool                          clearances,
                   double                        stiffness_per_pitch,
                   double                        driver_speed,
                   double                        tight_tension,
                   bool                          weightless  = false,
                   double                        weight      = 0.,
                   double                        centrifugal = 0.);

/// Velocities of a drive at speed, as of a four-bar linkage: the tight span is a rigid link between
/// the seats at its ends. The driver turns at @p driver_speed [rad/s] in the sense of the drive.
void set_in_motion(Layout &layout, double driver_speed);

/// Centre and direction of every link of @p layout from the bushes of its two joints.
void set_links(Layout &layout);
} // namespace chaindrive::drive
