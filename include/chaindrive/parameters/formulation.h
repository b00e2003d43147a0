// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Nothing but the enum: the element kernels include it, in which no library code may be.

namespace chaindrive::parameters
{
/// How a trilinear hexahedron is integrated.
enum class Formulation
{
  one_point, ///< mean gradient, hourglass stiffness after Flanagan and Belytschko (1981)
  enhanced,  ///< mean gradient, hourglass stiffness condensed from incompatible modes ("EAS1")
  full       ///< 2 x 2 x 2 points of Gauss' rule
};
} // namespace chaindrive::parameters
