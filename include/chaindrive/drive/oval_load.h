// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/facts.h>
#include <chaindrive/parameters/parameters.h>

namespace chaindrive::drive
{
/// The force with which the first tooth of the driver presses a roller in operation, over the
/// largest one that an oval between tooth and bush bears without buckling to a side: above 1
/// `Effects/Oval rollers` has no state of rest that is stable. The first is that of the triangle of
/// forces for the pressure angle 35 - 120 / z degrees (Binder and Covert 1948), the second that of
/// doc/theory.md, section 2, for a seat much wider than the roller: stiffness of the oval times
/// radial clearance of the bush, over four times the square of how much the bore follows the
/// outside. 0 of a chain without rollers, infinite without clearance.
double oval_load(const Parameters &parameters, const Facts &facts);
} // namespace chaindrive::drive
