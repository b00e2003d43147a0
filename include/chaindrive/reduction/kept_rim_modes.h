// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/rim_modes.h>
#include <chaindrive/statics/cache.h>
#include <chaindrive/utilities/announce.h>

#include <deal.II/base/mpi.h>

namespace chaindrive::reduction
{
/// make_rim_modes() from the @p cache if they are there: the same bit by bit on all ranks of
/// @p comm, whose first one computes them and reads and writes the cache. @p announce is told on
/// the first rank when they are computed. Collective.
RimModes kept_rim_modes(const drive::ToothForm         &form,
                        const mesh::SprocketDimensions &dimensions,
                        const Material                 &material,
                        double                          modes_up_to,
                        statics::Cache                 &cache,
                        MPI_Comm                        comm,
                        const Announce                 &announce = {});
} // namespace chaindrive::reduction
