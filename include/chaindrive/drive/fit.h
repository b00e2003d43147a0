// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/tensioner.h>
#include <chaindrive/parameters/drive.h>
#include <chaindrive/path/route.h>

#include <optional>
#include <vector>

namespace chaindrive::drive
{
/// A chain laid at one centre distance, or travel of a tensioner.
struct Fit
{
  double                   centre_distance;
  std::vector<path::Wheel> wheels;
  path::Laid               laid;
};

/// Finds routes and centre distances for a chain of given link lengths. Lengths in m.
struct Fitter
{
  /// A sprocket, as the chain is laid on it.
  struct Wheel
  {
    unsigned int     teeth;
    int              turn      = 1;     ///< see path::Wheel
    bool             moves     = false; ///< it is at the centre distance from wheel 0
    dealii::Point<2> centre    = {};    ///< of the axis of one that does not move
    double           direction = 0.;    ///< from wheel 0 to one that moves, from x, rad

    dealii::Tensor<1, 2> eccentricity = {}; ///< of the pitch circle, from the axis, m
    double               joints       = 0.; ///< radius on which they run on one without teeth, m
  };
  std::vector<Wheel> sprockets; ///< in the order in which the chain runs over them
  path::Chain        chain{};   ///< its bulge follows from the wheels, see bulge()

  /// Which way along y gravity pulls while the chain is laid, counter-clockwise: -1, +1 in a drive
  /// that is mirrored afterwards, 0 without gravity.
  int gravity = -1;

  /// The line of a guide that a spring presses against the slack span, as entries have it: this
  /// bulges away from it. Empty: there is none.
  std::vector<dealii::Point<2>> pressing = {};

  /// Whether slack grows with the centre distance, as where a wheel outside of the loop goes away,
  /// and does not fall.
  bool rises = false;

  /// Of the wheel that moves by its travel, in the place of a centre distance; else nothing moves
  /// so.
  std::optional<Tensioner> tensioner = {};

  /// What a centre distance is solved for: the part of the slack span that is excess, as a length
  /// or through its sag.
  struct Target
  {
    enum class Kind
    {
      slack, ///< length of the links less the distance they bridge, m
      sag    ///< over that distance
    };
    Kind   kind;
    double value;
  };

  /// The wheels, those that move at this distance from wheel 0, or with this travel.
  std::vector<path::Wheel> wheels(double centre_distance) const;

  /// Whether there is one that moves.
  bool moves() const;

  /// Which way the slack span bulges between these wheels (path::slack_span()): away from a guide
  /// that presses it, along gravity, outwards where there is none.
  int bulge(const std::vector<path::Wheel> &at) const;

  /// Routes at this centre distance, the best first; at least one unless the sprockets are within
  /// each other. @p straight: with a straight slack span, which makes the slack of the best route a
  /// continuous function of the centre distance. Only the @p most_tight best tight spans count.
  std::vector<Fit> fits(double centre_distance, bool straight, unsigned int most_tight = 4) const;

  /// The chain on that route; nothing if it cannot be.
  std::optional<Fit> fit(double centre_distance, const path::Route &route) const;

  /// Excess over the target; falls as the centre distance grows unless it #rises.
  static double excess(const Fit &fit, const Target &target);

  /// Centre distance in [low, high] that meets the target on the best route, to 0.1 um.
  double solve(const Target &target, double low, double high) const;

  /// The chain that meets the target on one route, near @p guess; nothing if there is none.
  std::optional<Fit> solve(const Target &target, const path::Route &route, double guess) const;
};

/// The sprockets of a drive, as @p chain is laid on them. Without a centre of its own the driver,
/// the first one, is at the origin, and another one moves.
std::vector<Fitter::Wheel> wheels_of(const parameters::Sprockets &sprockets,
                                     const ChainDimensions       &chain);
} // namespace chaindrive::drive
