// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace chaindrive::files
{
/// What one history, or one member of the summary, is: for those who read it.
struct Described
{
  /// Of a history `group/name`; of a member its name after those of the members in which it lies. A
  /// star stands for any name, or any place in a list: `engagements/*/time`.
  std::string path;
  std::string unit;    ///< SI, "1" for a pure number, empty where there is no number
  std::string meaning; ///< in words
};
} // namespace chaindrive::files
