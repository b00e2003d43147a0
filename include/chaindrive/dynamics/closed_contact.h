// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/contacts.h>
#include <chaindrive/element/elastic.h>
#include <chaindrive/world/world.h>

namespace chaindrive::dynamics
{
/// The stable step [s] of the elastic bodies of @p world with all nodes of all contacts held
/// closed;
/// @p limit [s] if that is smaller.
///
/// Positions follow from velocities half a step behind, at which the dampers are evaluated too:
/// with stiffness K and damping C the motion is bounded where dt^2 K + 2 dt C <= 4 M. A spring
/// between two bodies is no stiffer than two springs to the ground,
///   k (u - v)^2 <= k (1 + t) u^2 + k (1 + 1/t) v^2  for every t > 0,
/// which leaves each body alone with its elements and the springs of its nodes. The body that is
/// faster already is given the weaker spring: t is the ratio of the largest eigenvalues of the
/// other body and of this one, each bounded by the sum of the elements' and the springs' (Weyl).
double closed_contact_step(const World             &world,
                           const element::Elastic  &elastic,
                           const contact::Contacts &contacts,
                           double                   limit);

/// The stable step [s] of the nodes of @p family alone, held closed on otherwise free bodies;
/// infinite if it has none.
double closed_contact_step(const World &world, const contact::Family &family);
} // namespace chaindrive::dynamics
