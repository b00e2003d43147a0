// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/roller_laws.h>

namespace chaindrive::scene
{
namespace
{
double mass_of_both(const double a, const double b) { return a * b / (a + b); }

/// What touches a roller feels of its mass at once: where it becomes an oval, with the mass of that
/// in series.
double felt_mass(const double roller_mass, const std::optional<drive::RollerRing> &oval)
{
  return oval ? mass_of_both(roller_mass, oval->mass) : roller_mass;
}

/// Ovals lose by the dashpot what the ring does not carry.
ContactLaw of_roller(ContactLaw law, const std::optional<drive::RollerRing> &oval)
{
  if (oval)
    law.damping *= 0.5;
  return law;
}
} // namespace

ContactLaw make_tooth_law(const model::Contact                   &contact,
                          const double                            k,
                          const double                            roller_mass,
                          const double                            friction,
                          const std::optional<drive::RollerRing> &oval)
{
  return of_roller(make_law(contact, k, felt_mass(roller_mass, oval), friction), oval);
}

ContactLaw make_bush_law(const model::Contact                   &contact,
                         const double                            k,
                         const double                            roller_mass,
                         const double                            link_mass,
                         const std::optional<drive::RollerRing> &oval)
{
  return of_roller(make_law(contact,
                            k,
                            mass_of_both(felt_mass(roller_mass, oval), link_mass),
                            contact.roller_bush_friction),
                   oval);
}
} // namespace chaindrive::scene
