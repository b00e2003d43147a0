// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace test
{
/// Overrides that make a small full model of prm/paper/layered-auto.prm: 22 links between two
/// sprockets of 9 teeth.
inline const std::vector<std::string> small_full_drive = {
    "Model/Fidelity=full",
    "Mesh/Refinement=1",
    "Time/Step in us=auto",
    "Drive/Number of links=22",
    "Drive/Driver teeth=9",
    "Drive/Driven teeth=9",
    "Drive/Sprockets/Driver outside diameter in mm=auto",
    "Drive/Sprockets/Driven outside diameter in mm=auto",
    "Drive/Sprockets/Driver hub diameter in mm=auto",
    "Drive/Sprockets/Driver bore in mm=auto",
    "Drive/Sprockets/Driven hub diameter in mm=auto",
    "Drive/Sprockets/Driven bore in mm=auto",
    "Drive/Layout/Centre distance from=slack",
    "Drive/Layout/Slack in mm=0.1",
    "Model/Driven inertia in kg m2=1e-4",
    "Loads/Resisting torque in N m=20",
    "Loads/Torque ramp angle in rad=0.01"};

/// That drive with @p more overrides.
inline std::vector<std::string> small_full_drive_with(const std::vector<std::string> &more)
{
  std::vector<std::string> overrides = small_full_drive;
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}
} // namespace test
