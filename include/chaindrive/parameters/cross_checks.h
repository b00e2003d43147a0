// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// Looks for entries that contradict each other although each is allowed by itself. Throws
/// InputError with one sentence per contradiction, each saying what to change. Returns a sentence
/// for each entry that is harmless but has no effect, or not the effect that its name suggests.
std::vector<std::string> cross_check(const Parameters &parameters);
} // namespace chaindrive::parameters
