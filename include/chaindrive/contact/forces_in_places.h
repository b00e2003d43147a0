// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace chaindrive::contact
{
/// A family whose contacts stand side by side in places that never change, as it shows them to
/// those who look at all of them in every step.
class ForcesInPlaces
{
public:
  static constexpr unsigned int no_joint = static_cast<unsigned int>(-1);

  /// What stands at each of @p n places; valid as long as the family.
  struct View
  {
    unsigned int  n;
    const double *normal;     ///< force on the slave along the normal, N; 0: nothing touches
    const double *tangential; ///< force on it along the tangent (-y, x), where something touches, N
    const double *x, *y;      ///< the normal, unit
    const double *penetration; ///< m; 0: nothing touches
  };
  virtual View forces_in_places() const = 0;

  /// The joint of each place, or no_joint of one without a contact.
  virtual std::vector<unsigned int> joints_of_places() const = 0;

protected:
  ~ForcesInPlaces() = default;
};

/// The place of each of @p n_joints joints, if each has just one; else empty.
inline std::vector<unsigned int> places_of_joints(const ForcesInPlaces &family,
                                                  const unsigned int    n_joints)
{
  std::vector<unsigned int>       places(n_joints, ForcesInPlaces::no_joint);
  const std::vector<unsigned int> joints = family.joints_of_places();
  unsigned int                    n      = 0;
  for (unsigned int place = 0; place < joints.size(); ++place)
    if (joints[place] != ForcesInPlaces::no_joint)
      {
        if (joints[place] >= n_joints || places[joints[place]] != ForcesInPlaces::no_joint)
          return {};
        places[joints[place]] = place;
        ++n;
      }
  if (n < n_joints)
    return {};
  return places;
}
} // namespace chaindrive::contact
