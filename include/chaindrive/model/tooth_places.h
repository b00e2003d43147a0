// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

namespace chaindrive::model
{
/// Whether teeth of rigid sprockets are softer the higher a roller bears, where the decisions on
/// their @p compliance and on contact without penalty, @p exact, are these.
Decision
tooth_places(const Parameters &parameters, const Decision &compliance, const Decision &exact);

/// Whether the rims of these sprockets have inertia, where the decision on stiffness over place is
/// @p places.
Decision tooth_inertia(const Parameters &parameters, const Decision &places);
} // namespace chaindrive::model
