// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/closed_pair.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>

#include <vector>

namespace chaindrive::contact
{
/// The springs of the nodes of a @p cylinder with all of them closed in a @p bore, both centred,
/// with their bodies' axes parallel; @p stiffness per area, N/m3. By how much one is turned against
/// the other changes the critical time step by less than a thousandth. As in packed_joint.h the
/// point is carried by two columns of the bore and the two rings about it, and the force fades at
/// the bore's ends. @p of_vertex: nodes of the vertices of the two bodies.
std::vector<ClosedSpring> closed_springs(const mesh::CylinderGrid        &bore,
                                         const std::vector<unsigned int> &bore_of_vertex,
                                         const mesh::CylinderGrid        &cylinder,
                                         const std::vector<unsigned int> &of_vertex,
                                         double                           stiffness);
} // namespace chaindrive::contact
