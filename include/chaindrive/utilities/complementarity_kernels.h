// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

namespace chaindrive
{
/// Where the entry (@p i, 0) of a packed lower triangle is; the one at (i, j) is j numbers further.
constexpr unsigned long triangle_row(const unsigned long i) { return i * (i + 1) / 2; }

/// Positive definite systems of n_lanes problems side by side, and products with rows of one. All
/// arrays are aligned to 64 bytes.
struct ComplementarityKernels
{
  int width; ///< numbers that the machine computes at a time

  /// Makes the lower triangles @p a [triangle_row(i) + j][lane] of @p n rows their Cholesky
  /// factors, with the inverses of the diagonals in their place. An entry that is not positive on a
  /// diagonal becomes an inverse that is not finite.
  void (*factor)(unsigned int n, double *a);

  /// Makes @p x [row][lane] the solution of the systems whose factors @p l are, of which it is the
  /// right side.
  void (*solve)(unsigned int n, const double *l, double *x);

  /// Adds to @p sum the rows @p row [n_rows] of @p matrix, of @p stride numbers each, a multiple of
  /// n_lanes, times @p factor [n_rows].
  void (*add_rows)(unsigned int        stride,
                   const double       *matrix,
                   unsigned int        n_rows,
                   const unsigned int *row,
                   const double       *factor,
                   double             *sum);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none.
const ComplementarityKernels *complementarity_kernels(int width);
} // namespace chaindrive
