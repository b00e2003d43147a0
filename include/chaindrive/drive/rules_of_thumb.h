// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/numbers.h>

namespace chaindrive::drive
{
// Of makers' catalogues and textbooks on machine elements: what a drive is checked against, and
// what a selection keeps to.
inline constexpr double least_safety   = 7.;   ///< against breaking
inline constexpr double usual_pressure = 35e6; ///< of a lubricated joint, Pa
inline constexpr double least_wrap     = 2. * dealii::numbers::PI / 3.; ///< 120 degrees
} // namespace chaindrive::drive
