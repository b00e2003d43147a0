// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/statics/elastic_piece.h>

namespace chaindrive::statics
{
/// The largest principal stress on a side of a piece, and how well it is known.
struct PeakStress
{
  double        per_force = 0.; ///< of one newton on the piece, Pa/N
  unsigned long n_cells = 0, n_unknowns = 0;
  double        error = 0.; ///< estimated, relative
};

/// Of the side @p side when @p load, a single patch, bears one newton. The mesh is refined where
/// the error is largest until the last three refinements have changed the peak by less than @p
/// tolerance each; the largest of these changes is the estimated error.
PeakStress peak_stress(const Piece                 &piece,
                       const ElasticPiece::Patches &load,
                       dealii::types::boundary_id   side,
                       const Material              &material,
                       double                       tolerance,
                       MPI_Comm                     comm);
} // namespace chaindrive::statics
