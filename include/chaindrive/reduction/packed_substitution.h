// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/substitution_kernels.h>
#include <chaindrive/utilities/pack.h>

// Templates that substitution_kernels_*.cc instantiate for one instruction set each.

namespace chaindrive::reduction::packed
{
/// Takes column @p k times @p x [k] from the rows of @p x that it has entries in.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void take_column(const TriangleColumns &matrix,
                                          const unsigned int     k,
                                          const Pack<double, width> (&factor)[n_lanes / width],
                                          double *x)
{
  using Numbers = Pack<double, width>;
  for (unsigned int p = matrix.first[k]; p < matrix.first[k + 1]; ++p)
    {
      double *const to    = x + static_cast<unsigned long>(matrix.row[p]) * n_lanes;
      const Numbers entry = Numbers(matrix.entry[p]);
      for (int i = 0; i < n_lanes / width; ++i)
        (Numbers::load(to + i * width) - entry * factor[i]).store(to + i * width);
    }
}

template <int width>
void solve(const unsigned int     n,
           const TriangleColumns &lower,
           const TriangleColumns &upper,
           const double          *inverse,
           double                *x)
{
  using Numbers = Pack<double, width>;
  Numbers factor[n_lanes / width];
  for (unsigned int k = 0; k < n; ++k)
    {
      for (int i = 0; i < n_lanes / width; ++i)
        factor[i] = Numbers::load(x + static_cast<unsigned long>(k) * n_lanes + i * width);
      take_column<width>(lower, k, factor, x);
    }
  for (unsigned int k = n; k-- > 0;)
    {
      double *const at = x + static_cast<unsigned long>(k) * n_lanes;
      for (int i = 0; i < n_lanes / width; ++i)
        {
          factor[i] = Numbers::load(at + i * width) * Numbers(inverse[k]);
          factor[i].store(at + i * width);
        }
      take_column<width>(upper, k, factor, x);
    }
}

template <int width>
constexpr SubstitutionKernels make_substitution_kernels()
{
  return {width, solve<width>};
}
} // namespace chaindrive::reduction::packed
