// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/old_names.h>

namespace chaindrive::observe
{
const std::vector<std::pair<std::string, std::string>> &old_members()
{
  static const std::vector<std::pair<std::string, std::string>> all = {
      {"overlap_max", "penetration_max"},
      {"stable_step", "critical_time_step"},
      {"step", "time_step"}};
  return all;
}
} // namespace chaindrive::observe
