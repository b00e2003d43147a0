// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/design_life.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/files/json.h>

#include <string>

namespace chaindrive
{
/// Adds to `life` of a summary with these @p values what the run says of it: wear by the friction
/// work in the window with the coefficient of friction @p mu between pins and bushes, stresses of
/// the largest cycle of tension, impacts on the driver by their peaks. Nothing of what the run does
/// not have.
void add_simulated_life(files::Json             &values,
                        const drive::DesignLife &life,
                        const drive::Facts      &facts,
                        double                   mu);

/// What the run says of the life of the chain, for the log; nothing if it says nothing.
std::string simulated_life_in_words(const files::Json &life);
} // namespace chaindrive
