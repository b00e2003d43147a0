// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/system.h>
#include <chaindrive/scene/scene.h>

#include <vector>

namespace chaindrive::observe
{
/// Tension of every link and the state of the two spans at the last update().
///
/// A link's tension is its bar's (simple fidelity) or half the difference of the joint forces on
/// its two ends along its axis (layered). A span is made of the links whose middle lies, along the
/// line of centres, between 35 % and 65 % of the way from tangent point to tangent point of the
/// pitch circles, or within half a pitch of its middle where that is more; the tight one of those
/// that lead to the driver.
class Spans
{
public:
  Spans(const scene::Scene &scene, const dynamics::System &system);

  void update(const dynamics::System &system);

  const std::vector<double> &link_tension() const { return tension_; } ///< N, positive: pulled

  double tight_tension = 0.; ///< mean over the span's links, N
  double slack_tension = 0.; ///< N
  double tight_speed   = 0.; ///< mean velocity of its rollers in the span direction, m/s
  double tight_offset  = 0.; ///< mean displacement of its rollers' line along the normal, m
  double slack_offset  = 0.; ///< likewise of the slack span (away from the tight span negative), m

private:
  void joint_forces(const dynamics::System &system);

  const scene::Scene  &scene_;
  double               middle_;       ///< of both spans along x, m
  double               half_length_;  ///< of what counts, along x, m
  dealii::Tensor<1, 3> slack_normal_; ///< of the straight slack span, towards the tight one
  std::vector<const contact::Family *> joints_;    ///< bush-pin; none in simple fidelity
  std::vector<unsigned int>            links_;     ///< body of each link; none in simple fidelity
  std::vector<dealii::Tensor<1, 3>>    pin_force_; ///< on the pin of each joint, N
  std::vector<double>                  tension_;
};
} // namespace chaindrive::observe
