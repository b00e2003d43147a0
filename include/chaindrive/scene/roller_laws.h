// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/roller_ring.h>
#include <chaindrive/model/model.h>
#include <chaindrive/scene/contact_law.h>

#include <optional>

namespace chaindrive::scene
{
/// The laws of a rigid roller of @p roller_mass [kg] on teeth and on the bush of a link of
/// @p link_mass [kg], as make_law() (build.h) makes them of the stiffness @p k [N/m], of all points
/// of the contact together.
///
/// The damping ratio of @p contact stands for what waves carry away from a contact. Rollers that
/// become an @p oval carry a part of that themselves, and give it back. Theirs is half of the
/// ratio, with the masses that feel each other at once: those of the roller and its oval in series,
/// and the link's. This is what an elastic roller loses that is thrown at the bush of an elastic
/// link; on teeth it is a compromise (test contact/oval_rebound; doc/theory.md, 2). Friction that
/// sticks keeps its damping.
ContactLaw make_tooth_law(const model::Contact                   &contact,
                          double                                  k,
                          double                                  roller_mass,
                          double                                  friction,
                          const std::optional<drive::RollerRing> &oval);

/// See make_tooth_law(). Friction is that of rollers on bushes.
ContactLaw make_bush_law(const model::Contact                   &contact,
                         double                                  k,
                         double                                  roller_mass,
                         double                                  link_mass,
                         const std::optional<drive::RollerRing> &oval);
} // namespace chaindrive::scene
