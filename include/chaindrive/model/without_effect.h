// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::model
{
/// Of @p given, the paths of all entries that differ from their defaults, those that change nothing
/// in the fidelity and with the choices of @p parameters, from which @p effects have been decided:
/// a sentence for each reason.
std::vector<std::string> without_effect(const Parameters               &parameters,
                                        const Effects                  &effects,
                                        const std::vector<std::string> &given);
} // namespace chaindrive::model
