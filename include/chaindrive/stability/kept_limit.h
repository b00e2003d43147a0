// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/stability/closed_ways.h>
#include <chaindrive/statics/cache.h>

#include <functional>
#include <vector>

namespace chaindrive::stability
{
/// The limit [s] that @p find returns for bodies of @p world that @p windows, of @p n_families
/// families, hold and nothing else: from the cache @p kept if it has that of the same numbers, else
/// found and kept there. Each rank reads for itself. Null: it is always found.
double kept_limit(const World                     &world,
                  const std::vector<ClosedWindow> &windows,
                  unsigned int                     n_families,
                  statics::Cache                  *kept,
                  const std::function<double()>   &find);
} // namespace chaindrive::stability
