// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/archive.h>

#include <vector>

namespace chaindrive::observe
{
/// How the chain lies on a sprocket: in which tooth gaps, on their tips, or beside them.
///
/// Of roller k at the polar angle phi about a sprocket that has turned to the angle psi and has z
/// teeth, s z (phi - psi) / (2 pi) - k keeps its value as long as the chain moves with the teeth,
/// s = 1 for a sprocket that turns counter-clockwise and -1 for the others, and is a whole number
/// where the roller is in the middle of a gap. It is followed, for rollers that are on the
/// sprocket, from roller to roller; its median is the slip. Rollers count that are on the arc
/// between the tangent points of the pitch circles, but for a pitch at either end.
class Wrap
{
public:
  /// Of the rollers of @p scene on its sprocket number @p sprocket.
  Wrap(const scene::Scene &scene, unsigned int sprocket);

  /// Looks at the chain. It must not have slipped by half a pitch since the last call.
  void update(const World &world);

  /// By how many pitches the chain has moved ahead of the teeth since the start.
  double slip() const { return slip_; }

  /// The same as a whole number of teeth. It changes when three quarters of the way to the next gap
  /// are done: a roller that climbs a flank and falls back has not jumped.
  int jumped() const { return jumped_; }

  /// Whether no roller is in a gap, its centre within the outside diameter and between the sides of
  /// the sprocket. False where there are no rollers to look at, which nothing can be said of.
  bool is_off() const { return off_; }

  /// The rollers that are on a tip: the centre beyond the outside diameter by no more than the
  /// roller's radius, and less than a fifth of a pitch from the middle of a tooth.
  const std::vector<unsigned int> &on_tips() const { return on_tips_; }

  void serialize(const Archive &archive);

private:
  /// Where a roller of the arc is.
  struct Place
  {
    unsigned int joint;
    double       position; ///< s z (phi - psi) / (2 pi) - k, less any whole number, pitches
    double       radius;   ///< of its centre from the axis, m
    double       across;   ///< from the middle of the sprocket along its axis, m
  };

  /// The rollers of the arc.
  std::vector<Place> places(const World &world) const;

  /// Adds to each position the whole number that makes it follow from the last look, or from the
  /// roller beside it.
  void follow(std::vector<Place> &places);

  const scene::Scene       &scene_;
  unsigned int              body_, teeth_;
  int                       sense_;      ///< of its rotation
  dealii::Tensor<1, 3>      middle_;     ///< of the arc, from the axis, unit
  double                    half_angle_; ///< of the arc that is looked at, rad
  double                    outer_radius_, half_width_, roller_radius_; ///< m
  double                    z_; ///< of the middle plane of the teeth in the sprocket's frame, m
  std::vector<double>       position_; ///< per joint; not a number off the arc
  double                    slip_   = 0.;
  int                       jumped_ = 0;
  bool                      off_    = false;
  std::vector<unsigned int> on_tips_;
};
} // namespace chaindrive::observe
