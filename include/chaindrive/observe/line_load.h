// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface_contact.h>

#include <algorithm>

namespace chaindrive::observe
{
/// The largest load [N/m] at an end of a line of contact of @p family. Two neighbouring slaves of
/// a joint stand for each line, at the points of Gauss' rule: its load, linear along the line of
/// length L, is (F1 + F2 -+ sqrt(3) (F2 - F1)) / L at the ends.
/// Nodes of elastic bodies touch in many places, whose pressures are known: of them none is found.
double largest_edge_load(const contact::Family &family);

/// Calls @p visit for the records of @p family that the last search has left within reach.
template <typename Visit>
void for_each_near(const contact::Family &family, const Visit &visit)
{
  const auto &records = family.records();
  if (const auto *surface = dynamic_cast<const contact::SurfaceContact *>(&family))
    for (const unsigned int i : surface->near())
      visit(records[i]);
  else
    std::for_each(records.begin(), records.end(), visit);
}

} // namespace chaindrive::observe
