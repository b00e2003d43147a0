// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/elastic_flanks.h>
#include <chaindrive/contact/search_cadence.h>
#include <chaindrive/contact/surface_contact.h>

#include <memory>
#include <set>
#include <vector>

namespace chaindrive::contact
{
/// Lets the nodes of elastic flanks travel to the ranks whose slaves are near them.
///
/// It looks for them after every search, and before any slave can have moved by a margin as its
/// sprocket's hub sees it. When to look all ranks know by themselves, since they share all frames
/// and lists of slaves; whether anything has changed they tell each other then.
class NearFlanks
{
public:
  /// Slaves of @p family on @p flanks, both of which must outlive this.
  void add(const ElasticFlanks &flanks, const SurfaceContact &family);

  /// To be called before ghosts are fetched. @p searched: families have searched; @p dt is the time
  /// since the last call [s]. Collective.
  void update(World &world, bool searched, double dt);

  /// Everything has been placed anew: the next look() is at all.
  void forget() { cadence_ = {}; }

private:
  struct Item
  {
    const ElasticFlanks   *flanks;
    const SurfaceContact  *family;
    std::set<unsigned int> gaps = {}; ///< between teeth, that slaves of this rank are near
  };

  /// Largest speed [m/s] of a slave as the hub sees it, where all were when looked at last, and a
  /// margin farther out.
  double largest_speed(const World &world) const;

  std::vector<Item> items_;
  double            margin_   = 0.; ///< m
  double            farthest_ = 0.; ///< slave from its hub's axis when looked at last, m
  SearchCadence     cadence_;       ///< of the margin
};
} // namespace chaindrive::contact
