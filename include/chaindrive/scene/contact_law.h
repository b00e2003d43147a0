// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// No headers here: the kernels that are compiled for several instruction sets include this one, see
// utilities/pack.h.

namespace chaindrive::scene
{
/// Penalty and friction law of one slave point on one master surface, or, of elastic bodies whose
/// nodes touch, of a square metre of it (times()). The formulas are in contact/penalty.h. Number is
/// double or, in kernels, a pack of them.
template <typename Number>
struct ContactLawOf
{
  Number stiffness{};            ///< N/m, normal penalty
  Number damping{};              ///< N s/m, acts while the surfaces overlap
  Number friction{};             ///< Coulomb's coefficient
  Number tangential_stiffness{}; ///< N/m, of the sticking contact
  Number tangential_damping{};   ///< N s/m, of the sticking contact

  /// The law of one of @p n equal points that share this interface's stiffness.
  ContactLawOf shared_by(const unsigned int n) const { return times(1. / n); }

  /// The law of a node with the area @p factor, from a law per area.
  ContactLawOf times(const double factor) const
  {
    return {factor * stiffness,
            factor * damping,
            friction,
            factor * tangential_stiffness,
            factor * tangential_damping};
  }
};

using ContactLaw = ContactLawOf<double>;
} // namespace chaindrive::scene
