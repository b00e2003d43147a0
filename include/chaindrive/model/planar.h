// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::model
{
/// What is asked of rigid bodies in the plane and cannot be, a sentence for each, which says what
/// to choose.
std::vector<std::string> against_planar_motion(const Parameters &parameters,
                                               const Effects    &effects);
} // namespace chaindrive::model
