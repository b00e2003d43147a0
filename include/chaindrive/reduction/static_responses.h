// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>
#include <chaindrive/mesh/part.h>
#include <chaindrive/parameters/model.h>
#include <chaindrive/reduction/free_part.h>
#include <chaindrive/statics/cache.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace chaindrive::reduction
{
/// How quantities that are linear in the displacements of a part, s u, such as stresses, follow
/// from forces f on its nodes in statics: as g f, with g = G s and the flexibility G of all its
/// modes (FreePart::displacement(), which is symmetric). With a basis of modes Phi of frequencies W
/// a part that vibrates has s u = g f - s Phi W^-2 q" (mode acceleration method): what the basis
/// leaves of the flexibility is in g.
///
/// One g [unit / N] for each of the @p quantities s [unit / m], of @p part; from the @p cache if
/// they are there. The same bit by bit on all ranks of @p comm. Collective.
std::vector<Vector> kept_static_responses(const mesh::Part           &part,
                                          const Material             &material,
                                          const parameters::Elements &elements,
                                          const std::vector<Vector>  &quantities,
                                          statics::Cache             &cache,
                                          MPI_Comm                    comm);
} // namespace chaindrive::reduction
