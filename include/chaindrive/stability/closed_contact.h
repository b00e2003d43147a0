// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/contacts.h>
#include <chaindrive/statics/cache.h>

namespace chaindrive::stability
{
/// The critical time step [s] of the elastic bodies of @p world with all nodes of all contacts held
/// closed, if it is smaller than that of the elements alone, @p limit [s].
///
/// Positions follow from velocities half a step behind, at which the dampers are evaluated too:
/// with stiffness K and damping C the motion is bounded where dt^2 K + 2 dt C <= 4 M. A spring
/// between two bodies is no stiffer than two springs to the ground,
///   k (u - v)^2 <= k (1 + t) u^2 + k (1 + 1/t) v^2  for every t > 0,
/// which leaves each body alone with its elements and the springs of its nodes. The t of two bodies
/// is that which makes their bounds equal (Weyl: the largest eigenvalues of elements and springs
/// add up); so the slower body bears most. Modal bodies are not taken apart where
/// they meet only each other and the ground, see CoupledModes. @p kept: see closed_windows.h.
double closed_contact_time_step(const World             &world,
                                const contact::Contacts &contacts,
                                double                   limit,
                                statics::Cache          *kept = nullptr);

/// The critical time step [s] of the nodes of @p family alone, held closed on otherwise free
/// bodies; infinite if it has none.
double closed_contact_time_step(const World           &world,
                                const contact::Family &family,
                                statics::Cache        *kept = nullptr);
} // namespace chaindrive::stability
