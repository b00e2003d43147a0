// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

namespace chaindrive::reduction
{
/// The entries of a triangular matrix outside its diagonal, column after column.
struct TriangleColumns
{
  const unsigned int *first; ///< [n + 1], of each column and the end of the last one
  const unsigned int *row;
  const double       *entry;
};

/// Solutions of n_lanes systems with one sparse matrix side by side.
struct SubstitutionKernels
{
  int width; ///< numbers that the machine computes at a time

  /// Makes @p x [n][lane], aligned to 64 bytes, the solution of L U y = x, where L has ones on its
  /// diagonal and U the inverses of @p inverse [n].
  void (*solve)(unsigned int           n,
                const TriangleColumns &lower,
                const TriangleColumns &upper,
                const double          *inverse,
                double                *x);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none.
const SubstitutionKernels *substitution_kernels(int width);
} // namespace chaindrive::reduction
