// SPDX-License-Identifier: LGPL-2.1-or-later
// By the compiler for several instruction sets, of which the program takes the widest that the
// machine has when it is loaded; without fused multiply-adds (see CMakeLists.txt), so that all of
// them give the same numbers.
#include <chaindrive/bodies/turning.h>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__)
#define CHAINDRIVE_FOR_EACH_MACHINE __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define CHAINDRIVE_FOR_EACH_MACHINE
#endif

namespace chaindrive
{
namespace
{
using P = Pack<double, n_lanes>;

template <int n>
CHAINDRIVE_ALWAYS_INLINE void load(const double (&from)[n][n_lanes], P (&to)[n])
{
  for (int i = 0; i < n; ++i)
    to[i] = P::load(from[i]);
}

template <int n>
CHAINDRIVE_ALWAYS_INLINE void store(const P (&from)[n], double (&to)[n][n_lanes])
{
  for (int i = 0; i < n; ++i)
    from[i].store(to[i]);
}

/// w = R I^-1 R^T L.
CHAINDRIVE_ALWAYS_INLINE void
angular_velocity(const P (&r)[9], const P (&momentum)[3], const P (&inertia)[3], P (&w)[3])
{
  P in_body[3];
  for (int i = 0; i < 3; ++i)
    in_body[i] =
        (r[i] * momentum[0] + r[3 + i] * momentum[1] + r[6 + i] * momentum[2]) / inertia[i];
  for (int i = 0; i < 3; ++i)
    w[i] = r[3 * i] * in_body[0] + r[3 * i + 1] * in_body[1] + r[3 * i + 2] * in_body[2];
}

/// The product of rotation_by(@p h w) and @p q, of length one if @p normalize; returns |h w|^2.
CHAINDRIVE_ALWAYS_INLINE P
turned(const double h, const P (&w)[3], const P (&q)[4], const bool normalize, P (&now)[4])
{
  const P angle[3] = {P(h) * w[0], P(h) * w[1], P(h) * w[2]};
  const P square   = angle[0] * angle[0] + angle[1] * angle[1] + angle[2] * angle[2];
  const P s        = P(0.5) - square / P(48.) + square * square / P(3840.),
          a0 = P(1.) - square / P(8.) + square * square / P(384.), a1 = s * angle[0],
          a2 = s * angle[1], a3 = s * angle[2];
  now[0] = a0 * q[0] - a1 * q[1] - a2 * q[2] - a3 * q[3];
  now[1] = a0 * q[1] + a1 * q[0] + a2 * q[3] - a3 * q[2];
  now[2] = a0 * q[2] - a1 * q[3] + a2 * q[0] + a3 * q[1];
  now[3] = a0 * q[3] + a1 * q[2] - a2 * q[1] + a3 * q[0];
  if (normalize)
    {
      const P length = P(1.) / square_root(now[0] * now[0] + now[1] * now[1] + now[2] * now[2] +
                                           now[3] * now[3]);
      for (P &part : now)
        part = part * length;
    }
  return square;
}

CHAINDRIVE_ALWAYS_INLINE void to_matrix(const P (&q)[4], P (&r)[9])
{
  const P  one(1.), two(2.);
  const P &w = q[0], &x = q[1], &y = q[2], &z = q[3];
  r[0] = one - two * (y * y + z * z);
  r[1] = two * (x * y - w * z);
  r[2] = two * (x * z + w * y);
  r[3] = two * (x * y + w * z);
  r[4] = one - two * (x * x + z * z);
  r[5] = two * (y * z - w * x);
  r[6] = two * (x * z - w * y);
  r[7] = two * (y * z + w * x);
  r[8] = one - two * (x * x + y * y);
}
} // namespace

CHAINDRIVE_FOR_EACH_MACHINE
void find_angular_velocity(Turning &bodies)
{
  P rotation[9], momentum[3], inertia[3], w[3];
  load(bodies.rotation, rotation);
  load(bodies.momentum, momentum);
  load(bodies.inertia, inertia);
  angular_velocity(rotation, momentum, inertia, w);
  store(w, bodies.angular_velocity);
}

CHAINDRIVE_FOR_EACH_MACHINE
bool turn(Turning &bodies, const double dt)
{
  P rotation[9], momentum[3], inertia[3], q[4], half[4], now[4], w[3];
  load(bodies.rotation, rotation);
  load(bodies.momentum, momentum);
  load(bodies.inertia, inertia);
  load(bodies.orientation, q);
  angular_velocity(rotation, momentum, inertia, w);
  const P square_before = turned(0.5 * dt, w, q, false, half);
  to_matrix(half, rotation);
  angular_velocity(rotation, momentum, inertia, w);
  const P square = turned(dt, w, q, true, now);
  const P beyond = greatest(square_before, square) - P(most_turned * most_turned);
  for (int lane = 0; lane < n_lanes; ++lane)
    if (!(beyond[lane] < 0.)) // as if it is not a number
      return false;
  to_matrix(now, rotation);
  store(w, bodies.angular_velocity);
  store(now, bodies.orientation);
  store(rotation, bodies.rotation);
  return true;
}
} // namespace chaindrive
