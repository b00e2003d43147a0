// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/drive.h>

#include <string>
#include <vector>

namespace chaindrive::observe
{
/// Stands in documents of histories for the name of any other sprocket, or span between some.
inline constexpr const char *any_sprocket = "*", *any_span = "*_to_*";

/// Names of the sprockets that each drive has, and of any other: what documents of histories list.
inline std::vector<std::string> known_sprockets()
{
  std::vector<std::string> names;
  for (const parameters::Sprocket &sprocket : parameters::Sprockets().list)
    names.push_back(sprocket.name);
  names.push_back(any_sprocket);
  return names;
}

/// The same of the spans between them, in the direction of travel from the driver on.
inline std::vector<std::string> known_spans()
{
  const auto               sprockets = parameters::Sprockets().list;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < sprockets.size(); ++i)
    names.push_back(sprockets[i].name + "_to_" + sprockets[(i + 1) % sprockets.size()].name);
  names.push_back(any_span);
  return names;
}
} // namespace chaindrive::observe
