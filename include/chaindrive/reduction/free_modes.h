// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/free_part.h>

namespace chaindrive::reduction
{
/// A mode in which a part vibrates.
struct Mode
{
  double omega;  ///< rad/s
  Vector vector; ///< 1/sqrt(kg)
};

/// The natural modes of @p part up to the frequency @p highest [rad/s] without rigid motions, K phi
/// = omega^2 M phi, phi^T M phi = 1, ascending. Equal frequencies, of which round parts have many,
/// are all found: the search goes on beside what it has found until only higher ones are left.
/// InputError if the mesh has not many more unknowns than such modes.
std::vector<Mode> free_modes(const FreePart &part, double highest);
} // namespace chaindrive::reduction
