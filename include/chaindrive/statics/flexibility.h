// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/statics/contact_problem.h>
#include <chaindrive/statics/elastic_piece.h>

#include <vector>

namespace chaindrive::statics
{
/// A cylindrical side of a piece that is pressed.
struct Side
{
  dealii::types::boundary_id id;
  PatchGrid                  grid;
  dealii::Point<2>           axis;  ///< of the cylinder that presses, m
  double                     angle; ///< of the line along which it is pressed, from +x, rad
  bool                       bore;  ///< the side is pressed away from the axis
  bool across = false; ///< the piece is there on both sides of the line: patches are twice as large
                       ///< as those of the grid, and deflect by the mean of both
};

/// How a piece deflects, and how well that is known.
struct PieceFlexibility
{
  Flexibility   values; ///< of the patches of all its sides, one after the other, m/Pa
  unsigned long n_cells = 0, n_unknowns = 0;
  double        error = 0.; ///< estimated, of its compliance, relative
};

/// Solves for pressure on every patch of @p sides. The mesh is refined where the error is largest
/// until the last refinement has changed the compliance under a smooth pressure on each of the
/// sides by less than @p tolerance; that change is the estimated error.
PieceFlexibility flexibility(const Piece             &piece,
                             const std::vector<Side> &sides,
                             const Material          &material,
                             double                   tolerance,
                             MPI_Comm                 comm);
} // namespace chaindrive::statics
