// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/basis.h>

namespace chaindrive::reduction
{
/// Slows all modes of @p basis that are faster than @p cap [rad/s] to it, without a change of
/// their compliance phi phi^T / omega^2: they get more mass. A force of the frequency w then meets
/// phi phi^T / (cap^2 - w^2) * (cap / omega)^2 instead of phi phi^T / (omega^2 - w^2), so that a
/// mode deflects too much by (w / cap)^2 - (w / omega)^2 of its compliance. Statics stay, also
/// where Basis::joints knows nothing of a force: along, round, and from one end of a link to the
/// other.
void add_mass(Basis &basis, double cap);

/// Slows all natural modes of the @p basis of a roller that are faster than @p cap [rad/s] to it,
/// without a change of their inertia as slow motions meet it: such a mode keeps s = (cap / omega)^2
/// of its compliance, and Basis::joints, what sides deflect without inertia, gets the rest. A force
/// of the frequency w meets phi phi^T / omega^2 times 1 - s + s / (1 - w^2 / cap^2), which is
/// 1 + (w / omega)^2 + O(w^4), as before. That is exact for forces away from the axis where all
/// sides they act on are in Basis::joints and the part is round; what other forces deflect gets
/// stiffer by what leaves the modes.
void share_inertia(Basis &basis, double cap);

/// Does what fits the @p part, as far as @p options ask for it: share_inertia() for rollers,
/// add_mass() for all others. Basis::errors, if there are any, are those of contact_loads() before
/// and afterwards.
void slow_down(const mesh::Part &part, const BasisOptions &options, Basis &basis);
} // namespace chaindrive::reduction
