// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/layout.h>
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/path/obstacle.h>
#include <chaindrive/path/wheel.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <vector>

namespace chaindrive::drive
{
/// The chain of a rigid model, as statics see it: elastic bars between points that bear on the
/// teeth, without friction. In the simple model the points are the lumped rollers. In the layered
/// one they are the bushes: a rigid inner link is a bar of its own length, an outer link with the
/// joints at its two ends, which only pull along it, one of its loaded pitch; a bush bears on the
/// tooth through its roller, whose two contacts are in series along one normal.
struct RestingChain
{
  path::LinkLengths length;                           ///< without load, from point to point, m
  double            inner_stiffness, outer_stiffness; ///< of the links, N/m
  double            weight;                           ///< of one pitch, along -y, N
  double            roller_radius;                    ///< m
  double            tooth_stiffness;                  ///< of a roller on a tooth, N/m
  double            bush_clearance; ///< radial, of bush and roller; 0: they are one, m
  double            bush_stiffness; ///< of a bush in its roller, where they are two, N/m
  JointShifts       shifts = {};

  std::vector<double> deviations = {}; ///< of single links from these lengths, m; empty: none

  /// Of joints, which are an outer link's compliance, and contacts: instead of the stiffnesses
  /// above where there are some.
  StiffnessCurves curves = {};
};

/// What plates touch something with, in the place of rollers: their round ends.
struct RestingPlates
{
  double radius;    ///< m
  double stiffness; ///< of those of one joint, N/m
};

/// A wheel, as statics see it.
struct RestingWheel
{
  std::shared_ptr<const path::Obstacle> outline;
  double                                lever;          ///< radius of its pitch circle, m
  double                                seats;          ///< on a whole turn: its teeth
  bool                                  held   = false; ///< it does not turn
  double                                torque = 0.;    ///< counter-clockwise, N m

  /// Of the springs that hold its axis along x and y, N/m; empty: it stands still.
  std::optional<dealii::Tensor<1, 2>> bearing = {};
  std::optional<RestingPlates>        plates  = {}; ///< they lie on it, and not rollers
};

/// A sprocket, of which @p form must live as long.
RestingWheel resting_sprocket(const ToothForm &form, bool held, double torque = 0.);

/// A guide that a spring presses against the chain, as statics see it.
struct RestingGuide
{
  std::shared_ptr<const path::Obstacle> outline; ///< without travel, about the pivot of an arm
  RestingPlates                         plates;
  Tensioner                            *held; ///< whose travel is found
};

/// Moves chain, wheels and the shaft of wheel 1 so that the drive of @p layout, whose wheels turn
/// freely unless they are held, rests in equilibrium with the mean tension @p tension [N] in the
/// middle of its spans: minimum of the energy by Newton's method, the shaft by secants along x.
/// Without friction, which holds what has been laid so.
///
/// @throws InputError, naming Drive/Layout/Pretension in N, when there is no such state.
void bring_to_rest(Layout                          &layout,
                   const RestingChain              &chain,
                   const std::vector<RestingWheel> &wheels,
                   double                           tension);

/// The same without load, where the tensioner of the layout keeps the tension and is the only shaft
/// that moves; nothing does where it leans on its greatest stop and leaves slack.
///
/// @throws InputError, naming Drive/Wheels, when there is no such state.
void bring_to_rest(Layout                          &layout,
                   const RestingChain              &chain,
                   const std::vector<RestingWheel> &wheels);

/// The same where @p guide keeps the tension. It moves alone where it leans on its greatest stop,
/// clear of the chain.
///
/// @throws InputError, naming the guide's entries, when there is no such state.
void bring_to_rest(Layout                          &layout,
                   const RestingChain              &chain,
                   const std::vector<RestingWheel> &wheels,
                   const RestingGuide              &guide);

/// How a drive runs.
struct Operation
{
  double driver_speed;    ///< of wheel 0, magnitude, rad/s
  double mass_per_pitch;  ///< kg
  bool   follows_polygon; ///< other wheels turn with the polygon's speed of their phase, as they do
                          ///< below their resonance on straight spans, or with their means
};

/// Moves chain, free wheels and the tensioner of @p layout, or @p guide, to where they balance
/// their torques while the drive runs, and sets them in motion: minimum of the energy as above, in
/// which the tension that pulls at a joint is less by what turns the chain's own momentum, m v^2.
/// Teeth take their shares of the tension at the angles at which rollers bear on them then. Without
/// friction. Joints in a span run along its polygon, or, where the tooth frequency is below that of
/// the span as a string, swing with the rollers at its ends.
///
/// @throws InputError, naming Drive/Layout/Start, when no such state is found.
void settle(Layout                          &layout,
            const RestingChain              &chain,
            const std::vector<RestingWheel> &wheels,
            const Operation                 &operation,
            const RestingGuide              *guide = nullptr);
} // namespace chaindrive::drive
