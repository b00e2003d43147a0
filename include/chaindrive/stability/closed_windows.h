// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/family.h>
#include <chaindrive/statics/cache.h>

#include <vector>

namespace chaindrive::stability
{
/// The critical time step [s] of modal bodies that some of @p families hold without penalty;
/// infinite without such.
///
/// Where the patches of a set are closed and what they meet stands still, the modes and rigid
/// motions of a body have the matrix W^2 + N^T C^-1 N, with what they displace patches by, N, and
/// what these deflect without inertia, C, of this body alone. No system of bodies whose joints are
/// closed in such sets is faster than the fastest of its bodies so held: its elastic energy is the
/// least over all deflections that close the gaps, and one that returns all patches of each body to
/// where they were closes them all. Bodies may be taken together instead, with their joints as they
/// are: a link is with the rollers on its bushes (HeldLink), all other bodies are taken alone
/// (HeldBody). Springs of other contacts on the same bodies are added, dampers
/// with them. A rigid body that strips meet cannot return them: with all of these bodies at rest it
/// vibrates against the springs K of its strips with a square of frequency that is added to those
/// of the modal bodies, since the largest eigenvalue of a sum, K^1/2 (B M^-1 B^T) K^1/2 over all
/// bodies, is at most the sum of their largest ones.
///
/// Each side closes in a window about one of n_directions. Of several sides of a body the worst
/// directions are searched for one after the other, from some that all sides have in common, until
/// none gets worse.
///
/// Where no other contacts hold these bodies, the limit is read from the cache @p kept, if there is
/// one that has it, and else kept there.
double closed_windows_time_step(const World                                &world,
                                const std::vector<const contact::Family *> &families,
                                statics::Cache                             *kept = nullptr);
} // namespace chaindrive::stability
