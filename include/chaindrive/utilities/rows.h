// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// No headers of the library: see pack.h.

#include <chaindrive/utilities/pack.h>

namespace chaindrive
{
/// The rows of an array [row][column] at one column after the other, without a computation for each
/// of them: a processor adds 1, 2, 4 or 8 times a register to an address for nothing. Rows 0, 1, 2,
/// 4 and 8 are found from the first, 5, 6, 7, 9 and 13 from the sixth one; others take arithmetic.
class Rows
{
public:
  /// Of rows of @p length numbers from @p first on, at the column @p column.
  CHAINDRIVE_ALWAYS_INLINE
  Rows(double *first, const unsigned int length, const unsigned int column)
      : first_(reinterpret_cast<char *>(first + column))
      , sixth_(first_ + 5 * static_cast<long>(length) * size)
      , length_(static_cast<long>(length) * size)
  {
  }

  /// Where the number in row @p row is.
  CHAINDRIVE_ALWAYS_INLINE double *of(const unsigned int row) const
  {
    const bool from_sixth = row == 5 || row == 6 || row == 7 || row == 9 || row == 13;
    char      *at = from_sixth ? sixth_ + (row - 5) * length_ : first_ + long(row) * length_;
    return reinterpret_cast<double *>(at);
  }

  /// Goes on by @p n columns.
  CHAINDRIVE_ALWAYS_INLINE void advance(const unsigned int n)
  {
    first_ += n * size;
    sixth_ += n * size;
  }

private:
  static constexpr long size = sizeof(double);

  char *first_, *sixth_;
  long  length_; ///< bytes
};

/// Whether any number of @p p is less than zero: any_less(p, 0), which eight numbers are told by a
/// mask where the machine has these.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool any_negative(const Pack<double, width> &p)
{
#ifdef __AVX512DQ__
  if constexpr (width == 8)
    {
      constexpr int less = 1, all = 0xff, round_as_set = 4;
      return __builtin_ia32_cmppd512_mask(p.v, Pack<double, 8>(0.).v, less, all, round_as_set) != 0;
    }
#endif
  return any_less(p, Pack<double, width>(0.));
}

/// The sum of all places of @p p.
template <typename Number, int width>
CHAINDRIVE_ALWAYS_INLINE Number sum_of(const Pack<Number, width> &p)
{
  if constexpr (width == 8)
    {
      Pack<Number, 4> half;
      half.v = __builtin_shufflevector(p.v, p.v, 0, 1, 2, 3) +
               __builtin_shufflevector(p.v, p.v, 4, 5, 6, 7);
      return (half[0] + half[2]) + (half[1] + half[3]);
    }
  Number sum = 0.;
  for (int i = 0; i < width; ++i)
    sum += p[i];
  return sum;
}
} // namespace chaindrive
