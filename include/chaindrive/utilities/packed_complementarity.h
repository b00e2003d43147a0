// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/complementarity_kernels.h>
#include <chaindrive/utilities/pack.h>

// Templates that complementarity_kernels_*.cc instantiate for one instruction set each.

namespace chaindrive::packed
{
// Updates go from left to right, so that those of one column do not wait for each other.

template <int width>
void factor(const unsigned int n, double *a)
{
  using Numbers = Pack<double, width>;
  // Two columns at a time: what is right of them is read and written once for both.
  for (unsigned int lane = 0; lane < n_lanes; lane += width)
    for (unsigned int k = 0; k < n; k += 2)
      {
        double *const first   = a + (triangle_row(k) + k) * n_lanes + lane;
        const Numbers inverse = Numbers(1.) / square_root(Numbers::load(first));
        inverse.store(first);
        if (k + 1 == n)
          continue;
        double *const second = a + (triangle_row(k + 1) + k) * n_lanes + lane;
        const Numbers below  = Numbers::load(second) * inverse;
        below.store(second);
        const Numbers other =
            Numbers(1.) / square_root(Numbers::load(second + n_lanes) - below * below);
        other.store(second + n_lanes);
        for (unsigned int i = k + 2; i < n; ++i)
          {
            double *const row    = a + triangle_row(i) * n_lanes + lane;
            const Numbers entry  = Numbers::load(row + k * n_lanes) * inverse;
            const Numbers beside = (Numbers::load(row + (k + 1) * n_lanes) - entry * below) * other;
            entry.store(row + k * n_lanes);
            beside.store(row + (k + 1) * n_lanes);
            for (unsigned int j = k + 2; j <= i; ++j)
              {
                const double *const of = a + (triangle_row(j) + k) * n_lanes + lane;
                (Numbers::load(row + j * n_lanes) - entry * Numbers::load(of) -
                 beside * Numbers::load(of + n_lanes))
                    .store(row + j * n_lanes);
              }
          }
      }
}

template <int width>
void solve(const unsigned int n, const double *l, double *x)
{
  using Numbers = Pack<double, width>;
  for (unsigned int lane = 0; lane < n_lanes; lane += width)
    {
      for (unsigned int k = 0; k < n; ++k)
        {
          const Numbers y = Numbers::load(x + k * n_lanes + lane) *
                            Numbers::load(l + (triangle_row(k) + k) * n_lanes + lane);
          y.store(x + k * n_lanes + lane);
          for (unsigned int i = k + 1; i < n; ++i)
            (Numbers::load(x + i * n_lanes + lane) -
             Numbers::load(l + (triangle_row(i) + k) * n_lanes + lane) * y)
                .store(x + i * n_lanes + lane);
        }
      for (unsigned int i = n; i-- > 0;)
        {
          const double *const row = l + triangle_row(i) * n_lanes + lane;
          const Numbers       y =
              Numbers::load(x + i * n_lanes + lane) * Numbers::load(row + i * n_lanes);
          y.store(x + i * n_lanes + lane);
          for (unsigned int k = 0; k < i; ++k)
            (Numbers::load(x + k * n_lanes + lane) - Numbers::load(row + k * n_lanes) * y)
                .store(x + k * n_lanes + lane);
        }
    }
}

/// Of @p n_packs packs from @p sum on.
template <int width, int n_packs>
CHAINDRIVE_ALWAYS_INLINE void add_some(const unsigned int  stride,
                                       const double       *matrix,
                                       const unsigned int  n_rows,
                                       const unsigned int *row,
                                       const double       *factor,
                                       double             *sum)
{
  using Numbers = Pack<double, width>;
  Numbers at[n_packs];
  for (int p = 0; p < n_packs; ++p)
    at[p] = Numbers::load(sum + p * width);
  for (unsigned int r = 0; r < n_rows; ++r)
    {
      const double *const entries = matrix + static_cast<unsigned long>(row[r]) * stride;
      const Numbers       times   = Numbers(factor[r]);
      for (int p = 0; p < n_packs; ++p)
        at[p] += times * Numbers::load(entries + p * width);
    }
  for (int p = 0; p < n_packs; ++p)
    at[p].store(sum + p * width);
}

template <int width>
void add_rows(const unsigned int  stride,
              const double       *matrix,
              const unsigned int  n_rows,
              const unsigned int *row,
              const double       *factor,
              double             *sum)
{
  constexpr int n_packs = 4;
  unsigned int  i       = 0;
  for (; i + n_packs * width <= stride; i += n_packs * width)
    add_some<width, n_packs>(stride, matrix + i, n_rows, row, factor, sum + i);
  for (; i < stride; i += width)
    add_some<width, 1>(stride, matrix + i, n_rows, row, factor, sum + i);
}

template <int width>
constexpr ComplementarityKernels make_complementarity_kernels()
{
  return {width, factor<width>, solve<width>, add_rows<width>};
}
} // namespace chaindrive::packed
