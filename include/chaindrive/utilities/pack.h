// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// No headers here: what includes this one is compiled for several instruction sets, and an inline
// function of the library among them could be linked into the program in its widest form.

#define CHAINDRIVE_ALWAYS_INLINE inline __attribute__((always_inline))

namespace chaindrive
{
/// How many copies of a number lie side by side in memory, on every machine.
constexpr int n_lanes = 8;

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
};
} // namespace chaindrive
