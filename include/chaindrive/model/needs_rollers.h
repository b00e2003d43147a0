// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::model
{
/// What cannot be with a chain without rollers, a sentence for each, which says what to choose;
/// none where the chain has rollers.
std::vector<std::string> against_bush_chain(const Parameters &parameters);

/// The same of an oil film where it is on: it is between rigid rollers, bushes and teeth.
std::vector<std::string> against_oil_film(const Parameters &parameters, const Effects &effects);
} // namespace chaindrive::model
