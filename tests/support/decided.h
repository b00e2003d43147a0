// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// What follows from the entries of a drive: its model and its scene.

#include <chaindrive/model/model.h>
#include <chaindrive/scene/build.h>

#include <string>
#include <vector>

namespace test
{
using namespace chaindrive;

inline model::Model model_of(const Parameters &parameters)
{
  return model::make_model(parameters, drive::make_drive(parameters));
}

/// Stiffnesses that are auto are estimated from dimensions. Meshes are looked for in @p folders.
inline scene::Scene scene_of(const Parameters               &parameters,
                             const scene::BasisOf           &basis_of = {},
                             const std::vector<std::string> &folders  = {"."})
{
  const drive::Drive drive = drive::make_drive(parameters);
  return scene::build_scene(model::make_model(parameters, drive), drive, folders, basis_of);
}
} // namespace test
