// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

namespace chaindrive::model
{
/// Decides all effects from their entries (`auto`, `on` or `off`), the coefficients behind these,
/// and what the run is asked for (needs.h). This is the only place where they are decided: who
/// reads entries checks them against these decisions, and a Model keeps them.
Effects decide_effects(const Parameters &parameters);

/// Time between two field outputs if there are any, s; 0: none. auto is a tenth of the pitch time
/// of the driver, or a millisecond of one that stands still.
double field_interval(const Parameters &parameters);
} // namespace chaindrive::model
