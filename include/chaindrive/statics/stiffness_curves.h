// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/statics/part_stiffness.h>

#include <string>

namespace chaindrive::statics
{
/// How the parts of a @p drive deflect over load and place, fitted to elastic solutions of
/// @p library at 0.1 to 3 times the @p load [N] and at the pressure of rated chains, and of teeth
/// at the bottom of the gap and at the end of the seat (seat_end()). Sprockets without teeth have
/// no curve. @p note becomes a sentence on them. Throws what the solutions do.
drive::StiffnessCurves
stiffness_curves(Library &library, const drive::Drive &drive, double load, std::string &note);
} // namespace chaindrive::statics
