// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::model
{
/// What cannot be with wheels that are out of line or with separate strands, a sentence for each,
/// which says what to choose; none where all wheels are in the plane of the drive and nothing is
/// asked of strands.
std::vector<std::string> against_misalignment(const Parameters &parameters, const Effects &effects);
} // namespace chaindrive::model
