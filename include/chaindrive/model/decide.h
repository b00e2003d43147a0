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

/// The least Reduction/Modes up to [Hz] with which joints have no penalty: modes alone tell one end
/// of a link what happens at the other (theory.md, section 3).
inline constexpr double least_modes_of_exact_joints = 110e3;

/// Whether anything overlaps that contact damping could damp: not rollers, bushes, pins and teeth
/// without penalty, but plates on each other and on guides.
bool anything_overlaps(const Parameters &parameters, bool exact_teeth, bool plate_faces);

/// Time between two field outputs if there are any, s; 0: none. auto is a tenth of the pitch time
/// of the driver, or a millisecond of one that stands still.
double field_interval(const Parameters &parameters);
} // namespace chaindrive::model
