// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/drive.h>

#include <string>
#include <vector>

namespace chaindrive::observe
{
/// Names of the sprockets that a parameter file can ask for: what documents of histories list.
inline std::vector<std::string> known_sprockets()
{
  std::vector<std::string> names;
  for (const parameters::Sprocket &sprocket : parameters::Sprockets().list)
    names.push_back(sprocket.name);
  return names;
}

/// Names of the spans between them, in the direction of travel from the driver on.
inline std::vector<std::string> known_spans()
{
  const std::vector<std::string> sprockets = known_sprockets();
  std::vector<std::string>       names;
  for (std::size_t i = 0; i < sprockets.size(); ++i)
    names.push_back(sprockets[i] + "_to_" + sprockets[(i + 1) % sprockets.size()]);
  return names;
}
} // namespace chaindrive::observe
