// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/layout.h>
#include <chaindrive/path/wheel.h>

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
};

/// Moves chain, driven sprocket and shaft so that the drive of @p layout, whose driver is held and
/// whose driven sprocket turns freely, rests in equilibrium with the mean tension @p tension [N] in
/// the middle of its two spans: minimum of the energy by Newton's method, centre distance by
/// secants. Without friction, which holds what has been laid so.
///
/// @throws InputError, naming Drive/Layout/Pretension in N, when there is no such state.
void bring_to_rest(Layout                       &layout,
                   const RestingChain           &chain,
                   const std::vector<ToothForm> &forms,
                   double                        tension);

/// How a drive runs.
struct Operation
{
  double driver_speed;    ///< magnitude, rad/s
  double torque;          ///< of the load, against the motion of the driven sprocket, N m
  double mass_per_pitch;  ///< kg
  bool   follows_polygon; ///< the driven side turns with the polygon's speed of its phase, as it
                          ///< does below its resonance on the tight span, or with its mean
};

/// Moves chain and driven sprocket of @p layout to where they balance the load torque while the
/// drive runs, and sets them in motion: minimum of the energy as above, in which the tension that
/// pulls at a joint is less by what turns the chain's own momentum, m v^2. Teeth take their shares
/// of the tension at the angles at which rollers bear on them then. Without friction.
///
/// @throws InputError, naming Drive/Layout/Start, when no such state is found.
void settle(Layout                       &layout,
            const RestingChain           &chain,
            const std::vector<ToothForm> &forms,
            const Operation              &operation);
} // namespace chaindrive::drive
