// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/scene/scene.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::observe
{
/// Normal forces on the teeth of one sprocket, now and their peaks since the last sample, N.
struct ToothForces
{
  ToothForces(std::string name, const unsigned int n_joints, const unsigned int n_gaps)
      : name(std::move(name))
      , roller(n_joints, 0.)
      , roller_peak(n_joints, 0.)
      , in_gap(n_gaps, 0.)
      , in_gap_peak(n_gaps, 0.)
      , pressure(n_joints, 0.)
  {
  }

  std::string                                  name;     ///< driver | driven
  std::vector<const contact::SurfaceContact *> families; ///< of rigid and of elastic rollers
  std::vector<double>                          roller, roller_peak; ///< per joint
  std::vector<double>                          in_gap, in_gap_peak; ///< per gap of the sprocket
  std::vector<double>                          pressure;            ///< per joint, Pa
  double                                       penetration = 0.;    ///< largest so far, m

  /// Largest in the window so far, Pa.
  double pressure_max = std::numeric_limits<double>::quiet_NaN();

  bool flat = false; ///< a drum: its gaps are sectors

  /// Looks at what presses now.
  void update()
  {
    for (const auto &[joint, gap] : pressed_)
      roller[joint] = in_gap[gap] = 0.;
    pressed_.clear();
    for (const contact::SurfaceContact *family : families)
      for (const contact::SurfaceContact::Press &press : family->presses())
        {
          for (unsigned int point = 0; point < press.n_points; ++point)
            {
              roller[press.joint] += press.normal;
              in_gap[press.feature] += press.normal;
            }
          // elsewhere forces are zero, and peaks are not less; sums of several only grow
          roller_peak[press.joint]   = std::max(roller_peak[press.joint], roller[press.joint]);
          in_gap_peak[press.feature] = std::max(in_gap_peak[press.feature], in_gap[press.feature]);
          penetration                = std::max(penetration, -press.gap);
          pressed_.emplace_back(press.joint, press.feature);
        }
  }

  /// The forces have come from elsewhere, a checkpoint: the next update() replaces all of them.
  void replace_all()
  {
    pressed_.clear();
    for (unsigned int k = 0; k < roller.size(); ++k)
      pressed_.emplace_back(k, 0);
    for (unsigned int g = 0; g < in_gap.size(); ++g)
      pressed_.emplace_back(0, g);
  }

private:
  std::vector<std::pair<unsigned int, unsigned int>> pressed_; ///< joints and gaps, at update()
};

/// Of each sprocket that rollers can touch, nothing looked at yet: of the strand with this number
/// in scene::InterfaceOf, 0 being the one that stands for the chain.
std::vector<ToothForces> make_tooth_forces(const scene::Scene     &scene,
                                           const dynamics::System &system,
                                           unsigned int            strand = 0);
} // namespace chaindrive::observe
