// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// No headers here: what includes this one is compiled for several instruction sets, and an inline
// function of the library among them could be linked into the program in its widest form.

#define CHAINDRIVE_ALWAYS_INLINE inline __attribute__((always_inline))

namespace chaindrive
{
/// How many copies of a number lie side by side in memory, on every machine.
constexpr int n_lanes = 8;

/// Batches of n_lanes copies that so many copies fill; the last one may have empty lanes.
constexpr unsigned int n_batches_of(const unsigned long n_copies)
{
  return static_cast<unsigned int>((n_copies + n_lanes - 1) / n_lanes);
}

/// Copies that are computed for them, those in empty lanes included.
constexpr unsigned int n_computed_of(const unsigned long n_copies)
{
  return n_batches_of(n_copies) * n_lanes;
}

/// The compiler's vector of @p width numbers; for one, the number itself.
template <typename Number, int width>
struct VectorOf;
template <>
struct VectorOf<double, 1>
{
  using type = double;
};
template <>
struct VectorOf<double, 2>
{
  using type = double __attribute__((vector_size(16), may_alias));
};
template <>
struct VectorOf<double, 4>
{
  using type = double __attribute__((vector_size(32), may_alias));
};
template <>
struct VectorOf<double, 8>
{
  using type = double __attribute__((vector_size(64), may_alias));
};

/// @p width numbers that take part in one operation together. A plain number takes part with the
/// same value in each place.
template <typename Number, int width>
struct Pack
{
  using Vector = typename VectorOf<Number, width>::type;

  Vector v;

  Pack() = default;
  CHAINDRIVE_ALWAYS_INLINE Pack(const Number x) : v(x - Vector{}) {}

  /// The numbers from @p p on, which is aligned for them.
  static CHAINDRIVE_ALWAYS_INLINE Pack load(const Number *p)
  {
    Pack r;
    r.v = *reinterpret_cast<const Vector *>(p);
    return r;
  }
  CHAINDRIVE_ALWAYS_INLINE void store(Number *p) const { *reinterpret_cast<Vector *>(p) = v; }

  /// The same wherever @p p points to.
  static CHAINDRIVE_ALWAYS_INLINE Pack load_unaligned(const Number *p)
  {
    Pack r;
    // clang takes a vector type of less alignment for an aligned one
    __builtin_memcpy(&r.v, p, sizeof(r.v));
    return r;
  }
  CHAINDRIVE_ALWAYS_INLINE void store_unaligned(Number *p) const
  {
    __builtin_memcpy(p, &v, sizeof(v));
  }

  CHAINDRIVE_ALWAYS_INLINE Pack &operator+=(const Pack &b)
  {
    v += b.v;
    return *this;
  }
  CHAINDRIVE_ALWAYS_INLINE Pack &operator-=(const Pack &b)
  {
    v -= b.v;
    return *this;
  }
  friend CHAINDRIVE_ALWAYS_INLINE Pack operator+(Pack a, const Pack &b)
  {
    a.v += b.v;
    return a;
  }
  friend CHAINDRIVE_ALWAYS_INLINE Pack operator-(Pack a, const Pack &b)
  {
    a.v -= b.v;
    return a;
  }
  friend CHAINDRIVE_ALWAYS_INLINE Pack operator*(Pack a, const Pack &b)
  {
    a.v *= b.v;
    return a;
  }
  friend CHAINDRIVE_ALWAYS_INLINE Pack operator/(Pack a, const Pack &b)
  {
    a.v /= b.v;
    return a;
  }

  /// The number in place @p i.
  CHAINDRIVE_ALWAYS_INLINE Number operator[](const int i) const
  {
    if constexpr (width == 1)
      return v;
    else
      return v[i];
  }

  /// Puts @p x into place @p i of @p a.
  friend CHAINDRIVE_ALWAYS_INLINE void set_lane(Pack &a, const int i, const Number x)
  {
    if constexpr (width == 1)
      a.v = x;
    else
      a.v[i] = x;
  }

  /// In each place, @p a where @p x < @p y and @p b elsewhere.
  friend CHAINDRIVE_ALWAYS_INLINE Pack if_less(const Pack &x,
                                               const Pack &y,
                                               const Pack &a,
                                               const Pack &b)
  {
    Pack r;
    r.v = x.v < y.v ? a.v : b.v;
    return r;
  }
  friend CHAINDRIVE_ALWAYS_INLINE Pack least(const Pack &a, const Pack &b)
  {
    return if_less(a, b, a, b);
  }
  friend CHAINDRIVE_ALWAYS_INLINE Pack greatest(const Pack &a, const Pack &b)
  {
    return if_less(b, a, a, b);
  }
  friend CHAINDRIVE_ALWAYS_INLINE Pack square_root(Pack a)
  {
    if constexpr (width == 1)
      a.v = __builtin_sqrt(a.v);
    else
      for (int i = 0; i < width; ++i)
        a.v[i] = __builtin_sqrt(a.v[i]);
    return a;
  }

  /// Whether @p x < @p y in any place.
  friend CHAINDRIVE_ALWAYS_INLINE bool any_less(const Pack &x, const Pack &y)
  {
    if constexpr (width == 8)
      {
        // eight comparisons one by one take longer: halves are joined until two numbers are left
        const auto less = x.v < y.v;
        const auto four = __builtin_shufflevector(less, less, 0, 1, 2, 3) |
                          __builtin_shufflevector(less, less, 4, 5, 6, 7);
        const auto two =
            __builtin_shufflevector(four, four, 0, 1) | __builtin_shufflevector(four, four, 2, 3);
        return (two[0] | two[1]) != 0;
      }
    bool any = false;
    for (int i = 0; i < width; ++i)
      any |= x[i] < y[i];
    return any;
  }
};

/// The same for one number, so that a formula can be a template over the type of its numbers.
CHAINDRIVE_ALWAYS_INLINE double
if_less(const double x, const double y, const double a, const double b)
{
  return x < y ? a : b;
}
CHAINDRIVE_ALWAYS_INLINE double least(const double a, const double b)
{
  return if_less(a, b, a, b);
}
CHAINDRIVE_ALWAYS_INLINE double greatest(const double a, const double b)
{
  return if_less(b, a, a, b);
}
CHAINDRIVE_ALWAYS_INLINE double square_root(const double a) { return __builtin_sqrt(a); }

/// Numbers from as many places in memory as the pack has: @p offset numbers after each of @p from.
template <typename Number, int width>
CHAINDRIVE_ALWAYS_INLINE Pack<Number, width> gather(const Number *const (&from)[width],
                                                    const unsigned int offset)
{
  static_assert(width == 1 || width == 2 || width == 4 || width == 8, "no such pack");
  const unsigned int  o = offset;
  Pack<Number, width> r;
  // written out, so that the numbers go straight into a register
  if constexpr (width == 1)
    r.v = from[0][o];
  else if constexpr (width == 2)
    r.v = typename Pack<Number, width>::Vector{from[0][o], from[1][o]};
  else if constexpr (width == 4)
    r.v = typename Pack<Number, width>::Vector{from[0][o], from[1][o], from[2][o], from[3][o]};
  else
    r.v = typename Pack<Number, width>::Vector{from[0][o],
                                               from[1][o],
                                               from[2][o],
                                               from[3][o],
                                               from[4][o],
                                               from[5][o],
                                               from[6][o],
                                               from[7][o]};
  return r;
}
} // namespace chaindrive
