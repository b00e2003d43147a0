// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "ranges.h"

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
/// Runs that drive from rest to full speed within 0.5 ms, and on to 1.5 ms, with @p more overrides.
/// Energy must close, the driver turn as prescribed and the chain pull the load round.
inline nlohmann::json start_small_full_drive(std::vector<std::string> more = {})
{
  more.insert(more.end(),
              {"Loads/Ramp time in ms=0.5",
               "Time/End time in ms=1.5",
               "Output/Window start in ms=1",
               "Output/CSV=true",
               "Output/Field interval in ms=1"});
  const nlohmann::json s      = run("prm/paper/layered-auto.prm", small_full_drive_with(more));
  const double         angle  = s["driven_angle_end"];
  const double         turned = 120.74 * (1.5e-3 - 0.25e-3); // rad: the ramp costs half its time
  range("energy imbalance / drive work", s["energy_imbalance_max"], 0., 1e-3);
  range("driven angle over driver's", angle / turned, 0.75, 1.);
  range("resisting work over torque times angle",
        s["resisting_work"].get<double>() / (20. * (angle - 0.5 * 0.01)),
        0.99,
        1.01);
  return s;
}
} // namespace test
