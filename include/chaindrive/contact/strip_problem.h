// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/strip_flexibility.h>

#include <cstddef>
#include <vector>

namespace chaindrive::contact
{
/// The strips of one roller that may touch a tooth now, whose forces are found together with those
/// in the roller's bore: see RollerStrips, JointBatch.
struct StripProblem
{
  const StripFlexibility   *flexibility = nullptr;
  std::vector<unsigned int> unknown;   ///< strips and rings, as StripFlexibility numbers them
  std::vector<double>       direction; ///< of each from the roller's centre, in the world, rad
  std::vector<double>       gap;       ///< of each, m, that its force makes no smaller
  std::vector<double>       force;     ///< of each, N; where the search begins: above 0

  unsigned int        bush = 0; ///< body of the bush in the roller, if there is a coupling
  std::vector<double> couple;   ///< by how much the energy falls as the tooth turns it, N m

  unsigned int n() const { return static_cast<unsigned int>(unknown.size()); }

  /// Room for @p n of them, without couples.
  void resize(const std::size_t n)
  {
    unknown.resize(n);
    direction.resize(n);
    couple.clear();
    gap.resize(n);
    force.resize(n);
  }

  void clear() { resize(0); }
};
} // namespace chaindrive::contact
