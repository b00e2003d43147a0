// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>

namespace chaindrive
{
/// The world that @p scene describes, distributed over the ranks of @p comm: its bodies at the
/// start, the copies of parts whose nodes move or touch, and the groups that move all of them. A
/// kind of body that moves in another way is a class derived from BodyGroup, and a line here.
World make_world(const scene::Scene &scene, MPI_Comm comm = MPI_COMM_SELF);
} // namespace chaindrive
