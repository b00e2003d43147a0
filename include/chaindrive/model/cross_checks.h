// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::model
{
/// Looks for entries that contradict each other, or the decisions @p effects made from them,
/// although each is allowed by itself. Throws InputError with one sentence per contradiction, each
/// saying what to change. Returns a sentence for each entry that is harmless but has no effect, or
/// not the effect that its name suggests. What is wrong is said before a drive is made, for which
/// parts may have to be solved: these checks take the decisions, and no Model.
std::vector<std::string> cross_check(const Parameters &parameters, const Effects &effects);
} // namespace chaindrive::model
