// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/model.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/statics/cache.h>
#include <chaindrive/utilities/announce.h>

#include <deal.II/base/mpi.h>

namespace chaindrive::reduction
{
/// The options of section `Reduction` for a chain of @p pitch [m], with modes for pressures in
/// joints and, of rollers, on their outside, or, without such, what these sides deflect without
/// inertia; and modes for pressures on the faces of plates. Frequencies that are `auto` where
/// joints have no penalty hold for a pitch of 15.875 mm and larger ones; parts of smaller chains
/// vibrate faster, in inverse proportion to their size, and so much higher these frequencies are.
BasisOptions options_of(const parameters::Reduction &reduction,
                        double                       pitch,
                        bool                         pressed_joints  = true,
                        bool                         pressed_outside = true,
                        bool                         pressed_faces   = false);

/// The basis of @p part, with its errors in statics, from the @p cache if it is there: the same bit
/// by bit on all ranks of @p comm, whose first one computes it and reads and writes the cache. What
/// is kept has its own frequencies; modes are slowed afterwards (slower_modes.h).
/// Throws what free_modes() does, and InputError if a side that touches is no cylinder. @p announce
/// is told on the first rank when it is computed. Collective.
Basis kept_basis(const mesh::Part           &part,
                 const Material             &material,
                 const parameters::Elements &elements,
                 const BasisOptions         &options,
                 statics::Cache             &cache,
                 MPI_Comm                    comm,
                 const Announce             &announce = {});
} // namespace chaindrive::reduction
