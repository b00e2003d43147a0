// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace chaindrive::observe
{
/// Members of the summary that had another name in earlier versions: that name, and the present
/// one. Paths as in schema(); what is below a member is found by both names.
const std::vector<std::pair<std::string, std::string>> &old_members();
} // namespace chaindrive::observe
