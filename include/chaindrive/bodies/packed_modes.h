// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of modal_kernels.h, for `width` bodies of a batch at a time: the numbers of
// a mode are read once for all of them.

#include <chaindrive/bodies/modal_kernels.h>
#include <chaindrive/utilities/pack.h>

namespace chaindrive::packed
{
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void cross(const P (&a)[3], const P (&b)[3], P (&c)[3])
{
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/// Entries of the rigid motion from @p first on.
template <int n, typename P>
CHAINDRIVE_ALWAYS_INLINE void
load_rigid(const double *rigid, const int first, const int lane, P (&to)[n])
{
#pragma GCC unroll 9
  for (int i = 0; i < n; ++i)
    to[i] = P::load(rigid + (first + i) * n_lanes + lane);
}

/// Sums over the classes of what they move, with the signs of each image, in place: the transform
/// of Walsh and Hadamard, which is its own transpose.
template <unsigned int n, unsigned int half = 1, typename P>
CHAINDRIVE_ALWAYS_INLINE void exchange_classes_and_images(P (&values)[n][3])
{
  if constexpr (half < n)
    {
#pragma GCC unroll 8
      for (unsigned int i = 0; i < n; ++i)
        if ((i & half) == 0)
          for (int d = 0; d < 3; ++d)
            {
              const P sum         = values[i][d] + values[i | half][d],
                      difference  = values[i][d] - values[i | half][d];
              values[i][d]        = sum;
              values[i | half][d] = difference;
            }
      exchange_classes_and_images<n, 2 * half>(values);
    }
}

/// How bodies carry nodes at y with the speed s in body axes: x = x_c + R y, v = v_c + A y + B s,
/// with w = [w] as a matrix A = w (R - e w R), B = R - 2 e w R.
template <int width>
struct Rigid
{
  using P = Pack<double, width>;
  P position[3], velocity[3], rotation[9], by_place[9], by_speed[9];
};

template <int width>
CHAINDRIVE_ALWAYS_INLINE void
find_rigid(const double *rigid, const int lane, const double earlier, Rigid<width> &c)
{
  using P = Pack<double, width>;
  P angular_velocity[3];
  load_rigid(rigid, rigid_position, lane, c.position);
  load_rigid(rigid, rigid_velocity, lane, c.velocity);
  load_rigid(rigid, rigid_rotation, lane, c.rotation);
  load_rigid(rigid, rigid_angular_velocity, lane, angular_velocity);
  const P e(earlier);
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j)
    {
      const P column[3] = {c.rotation[j], c.rotation[3 + j], c.rotation[6 + j]};
      P       turned[3], before[3], by_place[3];
      cross(angular_velocity, column, turned);
      for (int i = 0; i < 3; ++i)
        {
          before[i]             = column[i] - e * turned[i];
          c.by_speed[3 * i + j] = before[i] - e * turned[i];
        }
      cross(angular_velocity, before, by_place);
      for (int i = 0; i < 3; ++i)
        c.by_place[3 * i + j] = by_place[i];
    }
}

/// What the modes of class @p c move @p count orbits from number @p first on by, and their speeds
/// if
/// @p with_rate: each load of q serves all.
template <int width, int count, bool with_rate>
CHAINDRIVE_ALWAYS_INLINE void sum_of_class(const PlaceArguments &arg,
                                           const int             lane,
                                           const unsigned int    first,
                                           const unsigned int    c,
                                           Pack<double, width> (&u)[count][3],
                                           Pack<double, width> (&s)[count][3])
{
  using P                 = Pack<double, width>;
  const ModalNodes &nodes = arg.nodes;
  const double     *mode_shape[count];
  P                 q_sum[count][3], rate_sum[count][3];
  for (int n = 0; n < count; ++n)
    {
      mode_shape[n] =
          nodes.mode_shape + static_cast<unsigned long>(nodes.orbit[first + n]) * 3 * nodes.n_modes;
      for (int d = 0; d < 3; ++d)
        q_sum[n][d] = rate_sum[n][d] = P(0.);
    }
#pragma GCC unroll 1
  for (unsigned int m = nodes.first_mode[c]; m < nodes.first_mode[c + 1]; ++m)
    {
      const P q = P::load(arg.amplitude + m * n_lanes + lane);
      P       rate(0.);
      if (with_rate)
        rate = P::load(arg.rate + m * n_lanes + lane);
      for (int n = 0; n < count; ++n)
        for (int d = 0; d < 3; ++d)
          {
            const P phi(mode_shape[n][3 * m + d]);
            q_sum[n][d] += phi * q;
            if (with_rate)
              rate_sum[n][d] += phi * rate;
          }
    }
  for (int n = 0; n < count; ++n)
    for (int d = 0; d < 3; ++d)
      {
        u[n][d] = q_sum[n][d];
        if (with_rate)
          s[n][d] = rate_sum[n][d];
      }
}

/// Places the nodes of the orbit number @p orbit, which the classes move by @p u with the speeds @p
/// s, if @p with_rate.
template <int width, unsigned int n_images, bool with_rate>
CHAINDRIVE_ALWAYS_INLINE void place_orbit(const PlaceArguments &arg,
                                          const Rigid<width>   &rigid,
                                          const int             lane,
                                          const unsigned int    orbit,
                                          Pack<double, width> (&u)[n_images][3],
                                          Pack<double, width> (&s)[n_images][3])
{
  using P                  = Pack<double, width>;
  const unsigned int *node = arg.nodes.node + orbit * n_images;
  const P             per_step(with_rate ? 0. : 0.5 / arg.earlier);
  exchange_classes_and_images(u);
  if constexpr (with_rate)
    exchange_classes_and_images(s);
#pragma GCC unroll 8
  for (unsigned int g = 0; g < n_images; ++g)
    {
      if (node[g] == ModalNodes::none)
        continue;
      P y[3];
      for (int d = 0; d < 3; ++d)
        y[d] = P(arg.nodes.reference[3 * node[g] + d]) + u[g][d];
      for (int i = 0; i < 3; ++i)
        {
          const unsigned int at = (3 * node[g] + i) * n_lanes + lane;
          P                  x = rigid.position[i], v = rigid.velocity[i];
          for (int d = 0; d < 3; ++d)
            {
              x += rigid.rotation[3 * i + d] * y[d];
              if constexpr (with_rate)
                {
                  v += rigid.by_place[3 * i + d] * y[d];
                  v += rigid.by_speed[3 * i + d] * s[g][d];
                }
            }
          if constexpr (!with_rate)
            v = (x - P::load(arg.position + at)) * per_step;
          x.store(arg.position + at);
          v.store(arg.velocity + at);
        }
    }
}

/// Fetches what place_orbit() is going to read and write of image @p g of the orbit number @p
/// orbit: nodes lie apart, and by themselves would be waited for one after the other.
CHAINDRIVE_ALWAYS_INLINE void
fetch_image(const PlaceArguments &arg, const unsigned int orbit, const unsigned int g)
{
  const unsigned int node = arg.nodes.node[orbit * arg.nodes.n_images + g];
  if (node != ModalNodes::none)
    for (unsigned int i = 0; i < 3; ++i)
      {
        __builtin_prefetch(arg.position + (3 * node + i) * n_lanes, 1);
        __builtin_prefetch(arg.velocity + (3 * node + i) * n_lanes, 1);
      }
}

/// Places the nodes of @p count orbits from number @p first on.
template <int width, unsigned int n_images, int count, bool with_rate>
CHAINDRIVE_ALWAYS_INLINE void place_some(const PlaceArguments &arg,
                                         const Rigid<width>   &rigid,
                                         const int             lane,
                                         const unsigned int    first)
{
  using P = Pack<double, width>;
  P u[count][n_images][3], s[count][n_images][3];
#pragma GCC unroll 1
  for (unsigned int c = 0; c < n_images; ++c)
    {
      for (int n = 0; n < count; ++n)
        fetch_image(arg, arg.nodes.orbit[first + n], c);
      P moved[count][3], speed[count][3];
      sum_of_class<width, count, with_rate>(arg, lane, first, c, moved, speed);
      for (int n = 0; n < count; ++n)
        for (int d = 0; d < 3; ++d)
          {
            u[n][c ^ arg.nodes.reflection[d]][d] = moved[n][d];
            if (with_rate)
              s[n][c ^ arg.nodes.reflection[d]][d] = speed[n][d];
          }
    }
#pragma GCC unroll 1
  for (int n = 0; n < count; ++n)
    place_orbit<width, n_images, with_rate>(
        arg, rigid, lane, arg.nodes.orbit[first + n], u[n], s[n]);
}

template <int width, unsigned int n_images, int count, bool with_rate>
CHAINDRIVE_ALWAYS_INLINE void place_lanes(const PlaceArguments &arg, const int lane)
{
  Rigid<width> rigid;
  find_rigid(arg.nodes.rigid, lane, arg.earlier, rigid);
  unsigned int i = 0;
#pragma GCC unroll 1
  for (; i + count <= arg.nodes.n_orbits; i += count)
    place_some<width, n_images, count, with_rate>(arg, rigid, lane, i);
#pragma GCC unroll 1
  for (; i < arg.nodes.n_orbits; ++i)
    place_some<width, n_images, 1, with_rate>(arg, rigid, lane, i);
}

/// The force on a node in body axes, which becomes zero, if there is one in any lane; adds its
/// couple to @p moment.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool take_force(const GatherArguments &arg,
                                         const int              lane,
                                         const unsigned int     node,
                                         const Pack<double, width> (&rotation)[9],
                                         const Pack<double, width> (&centre)[3],
                                         Pack<double, width> (&moment)[3],
                                         Pack<double, width> (&in_body)[3])
{
  using P = Pack<double, width>;
  if (arg.pressed[node] == 0)
    return false;
  if (lane + width == n_lanes)
    arg.pressed[node] = 0;
  const unsigned int at = 3 * node * n_lanes + lane;
  P                  f[3], arm[3], couple[3];
  for (int d = 0; d < 3; ++d)
    f[d] = P::load(arg.force + at + d * n_lanes);
  if (!any_less(P(0.), f[0] * f[0] + f[1] * f[1] + f[2] * f[2]))
    return false;
  for (int d = 0; d < 3; ++d)
    {
      P(0.).store(arg.force + at + d * n_lanes);
      arm[d] = P::load(arg.position + at + d * n_lanes) - centre[d];
    }
  cross(arm, f, couple);
  for (int d = 0; d < 3; ++d)
    {
      moment[d] += couple[d];
      in_body[d] = rotation[d] * f[0] + rotation[3 + d] * f[1] + rotation[6 + d] * f[2];
    }
  return true;
}

/// Lists the orbits on which a force acts in any lane, with what these forces are to each class,
/// and sums up the couples. Returns their number.
template <int width, unsigned int n_images>
CHAINDRIVE_ALWAYS_INLINE unsigned int take_forces(const GatherArguments &arg, const int lane)
{
  using P                 = Pack<double, width>;
  const ModalNodes &nodes = arg.nodes;
  P                 rotation[9], centre[3], moment[3] = {P(0.), P(0.), P(0.)};
  load_rigid(nodes.rigid, rigid_rotation, lane, rotation);
  load_rigid(nodes.rigid, rigid_position, lane, centre);
  unsigned int n = 0;
#pragma GCC unroll 1
  for (unsigned int i = 0; i < nodes.n_orbits; ++i)
    {
      P    f[n_images][3];
      bool any = false;
#pragma GCC unroll 8
      for (unsigned int g = 0; g < n_images; ++g)
        {
          for (int d = 0; d < 3; ++d)
            f[g][d] = P(0.);
          const unsigned int node = nodes.node[nodes.orbit[i] * n_images + g];
          if (node != ModalNodes::none &&
              take_force<width>(arg, lane, node, rotation, centre, moment, f[g]))
            any = true;
        }
      if (!any)
        continue;
      exchange_classes_and_images(f);
#pragma GCC unroll 1
      for (unsigned int c = 0; c < n_images; ++c)
        for (int d = 0; d < 3; ++d)
          f[c ^ nodes.reflection[d]][d].store(arg.in_body + ((n * n_images + c) * 3 + d) * n_lanes +
                                              lane);
      arg.found[n++] = nodes.orbit[i];
    }
  for (int d = 0; d < 3; ++d)
    moment[d].store(arg.moment + d * n_lanes + lane);
  return n;
}

/// The generalised forces of @p count modes of class @p c from @p first on. Few modes have one sum
/// for each direction, so that additions need not wait for each other.
template <int width, int count>
CHAINDRIVE_ALWAYS_INLINE void project_forces(const GatherArguments &arg,
                                             const int              lane,
                                             const unsigned int     n,
                                             const unsigned int     c,
                                             const unsigned int     first)
{
  using P              = Pack<double, width>;
  constexpr int n_sums = count > 4 ? 1 : 3;
  P             sum[count][n_sums];
  for (int m = 0; m < count; ++m)
    for (int d = 0; d < n_sums; ++d)
      sum[m][d] = P(0.);
#pragma GCC unroll 1
  for (unsigned int i = 0; i < n; ++i)
    {
      const double *mode_shape =
          arg.nodes.mode_shape +
          3 * (static_cast<unsigned long>(arg.found[i]) * arg.nodes.n_modes + first);
      P f[3];
      for (int d = 0; d < 3; ++d)
        f[d] = P::load(arg.in_body + ((i * arg.nodes.n_images + c) * 3 + d) * n_lanes + lane);
      for (int d = 0; d < 3; ++d)
#pragma GCC unroll 8
        for (int m = 0; m < count; ++m)
          sum[m][d % n_sums] += P(mode_shape[3 * m + d]) * f[d];
    }
  for (int m = 0; m < count; ++m)
    {
      for (int d = 1; d < n_sums; ++d)
        sum[m][0] += sum[m][d];
      sum[m][0].store(arg.modal_force + (first + m) * n_lanes + lane);
    }
}

/// The measures of what take_forces() has found on @p n orbits.
template <int width, unsigned int n_images>
CHAINDRIVE_ALWAYS_INLINE void
measure_forces(const GatherArguments &arg, const int lane, const unsigned int n)
{
  using P                       = Pack<double, width>;
  const unsigned int n_measures = arg.n_measures;
#pragma GCC unroll 1
  for (unsigned int k = 0; k < n_measures; ++k)
    {
      P sum[3] = {P(0.), P(0.), P(0.)};
#pragma GCC unroll 1
      for (unsigned int i = 0; i < n; ++i)
        {
          const double *f = arg.in_body + i * n_images * 3 * n_lanes + lane,
                       *g = arg.measure +
                            (static_cast<unsigned long>(arg.found[i]) * n_images * n_measures + k) *
                                3;
#pragma GCC unroll 1
          for (unsigned int c = 0; c < n_images; ++c, f += 3 * n_lanes, g += 3 * n_measures)
            for (int d = 0; d < 3; ++d)
              sum[d] += P(g[d]) * P::load(f + d * n_lanes);
        }
      (sum[0] + sum[1] + sum[2]).store(arg.measured + k * n_lanes + lane);
    }
}

template <int width, unsigned int n_images>
CHAINDRIVE_ALWAYS_INLINE void gather_lanes(const GatherArguments &arg, const int lane)
{
  const unsigned int n = take_forces<width, n_images>(arg, lane);
  measure_forces<width, n_images>(arg, lane, n);
#pragma GCC unroll 1
  for (unsigned int c = 0; c < n_images; ++c)
    {
      unsigned int       m   = arg.nodes.first_mode[c];
      const unsigned int end = arg.nodes.first_mode[c + 1];
      for (; m + 8 <= end; m += 8)
        project_forces<width, 8>(arg, lane, n, c, m);
      for (; m + 4 <= end; m += 4)
        project_forces<width, 4>(arg, lane, n, c, m);
      for (; m + 2 <= end; m += 2)
        project_forces<width, 2>(arg, lane, n, c, m);
      for (; m < end; ++m)
        project_forces<width, 1>(arg, lane, n, c, m);
    }
}

/// As many orbits at a time as keep their sums in registers.
template <int width, unsigned int n_images>
CHAINDRIVE_ALWAYS_INLINE void place_all(const PlaceArguments &arg)
{
#pragma GCC unroll 1
  for (int lane = 0; lane < n_lanes; lane += width)
    if (arg.rate != nullptr)
      place_lanes<width, n_images, width == 8 ? 4 : 2, true>(arg, lane);
    else
      place_lanes<width, n_images, 4, false>(arg, lane);
}

template <int width, unsigned int n_images>
CHAINDRIVE_ALWAYS_INLINE void gather_all(const GatherArguments &arg)
{
#pragma GCC unroll 1
  for (int lane = 0; lane < n_lanes; lane += width)
    gather_lanes<width, n_images>(arg, lane);
}

template <int width>
void place(const PlaceArguments &arg)
{
  switch (arg.nodes.n_images)
    {
    case 1:
      return place_all<width, 1>(arg);
    case 2:
      return place_all<width, 2>(arg);
    case 4:
      return place_all<width, 4>(arg);
    default:
      return place_all<width, 8>(arg);
    }
}

template <int width>
void gather(const GatherArguments &arg)
{
  switch (arg.nodes.n_images)
    {
    case 1:
      return gather_all<width, 1>(arg);
    case 2:
      return gather_all<width, 2>(arg);
    case 4:
      return gather_all<width, 4>(arg);
    default:
      return gather_all<width, 8>(arg);
    }
}

template <int width>
constexpr ModalKernels make_modal_kernels()
{
  return {width, place<width>, gather<width>};
}
} // namespace chaindrive::packed
