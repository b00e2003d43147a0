// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/closed_pair.h>
#include <chaindrive/contact/closed_window.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/reduction/round_flexibility.h>
#include <chaindrive/scene/contact_law.h>

#include <functional>

namespace chaindrive::contact
{
/// One side of a joint with all of its nodes closed: each node carries the springs of its share of
/// the surface, @p area(ring) [m2]. The nodes of a rigid body have all of it to move: at the
/// distance r from its centre a spring k adds at most k (1/m + r^2/I), I the smallest moment of
/// inertia.
ClosedSide closed_side(const mesh::CylinderGrid                  &grid,
                       unsigned int                               surface,
                       const std::function<double(unsigned int)> &area,
                       double                                     stiffness,
                       const World                               &world,
                       unsigned int                               group);

/// The rings of @p side from @p first to @p last, of the mesh's @p grid.
ClosedWindow window_of(const reduction::RoundFlexibility &side,
                       const mesh::CylinderGrid          &grid,
                       unsigned int                       first,
                       unsigned int                       last,
                       const scene::ContactLaw           &law);
} // namespace chaindrive::contact
