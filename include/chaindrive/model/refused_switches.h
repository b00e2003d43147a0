// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::model
{
/// What switches of section Effects turn on that this model cannot have, of those whose decisions
/// say why: a sentence for each, which says what to choose.
std::vector<std::string> refused_switches(const Parameters &parameters, const Effects &effects);
} // namespace chaindrive::model
