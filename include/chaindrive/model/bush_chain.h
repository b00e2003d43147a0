// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::model
{
/// What cannot be with a chain without rollers, a sentence for each, which says what to choose;
/// none where the chain has rollers.
std::vector<std::string> against_bush_chain(const Parameters &parameters);
} // namespace chaindrive::model
