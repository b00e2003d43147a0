// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of modal_kernels.h, for `width` bodies of a batch at a time: the numbers of
// a shape are read once for all of them.

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

constexpr unsigned int most_images = 8;

/// Sums over the classes of what they move, with the signs of each image, in place: the transform
/// of Walsh and Hadamard, which is its own transpose. Entry g or c of a node is @p stride further.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void
exchange_classes_and_images(P *values, const unsigned int stride, const unsigned int n)
{
#pragma GCC unroll 1
  for (unsigned int half = 1; half < n; half *= 2)
#pragma GCC unroll 1
    for (unsigned int i = 0; i < n; ++i)
      if ((i & half) == 0)
        {
          P *a = values + i * stride, *b = values + (i + half) * stride;
#pragma GCC unroll 12
          for (unsigned int d = 0; d < stride; ++d)
            {
              const P sum = a[d] + b[d], difference = a[d] - b[d];
              a[d] = sum;
              b[d] = difference;
            }
        }
}

/// How a batch stands and moves as rigid bodies, in registers.
template <int width>
struct Rigid
{
  using P = Pack<double, width>;
  P rotation[9], position[3], velocity[3], turning[3];

  CHAINDRIVE_ALWAYS_INLINE Rigid(const double *rigid, const int lane)
  {
    load_rigid(rigid, rigid_rotation, lane, rotation);
    load_rigid(rigid, rigid_position, lane, position);
    load_rigid(rigid, rigid_velocity, lane, velocity);
    load_rigid(rigid, rigid_turning, lane, turning);
  }
};

/// Places one node that the shapes move by @p u with the speed @p s, both in body axes.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void place_node(const PlaceArguments &arg,
                                         const Rigid<width>   &rigid,
                                         const int             lane,
                                         const unsigned int    node,
                                         const Pack<double, width> (&u)[3],
                                         const Pack<double, width> (&s)[3])
{
  using P = Pack<double, width>;
  P y[3], arm[3], speed[3], turned[3], velocity[3];
  for (int i = 0; i < 3; ++i)
    y[i] = P(arg.nodes.reference[3 * node + i]) + u[i];
  for (int i = 0; i < 3; ++i)
    {
      const P *row = rigid.rotation + 3 * i;
      arm[i]       = row[0] * y[0] + row[1] * y[1] + row[2] * y[2];
      speed[i]     = row[0] * s[0] + row[1] * s[1] + row[2] * s[2];
    }
  const P earlier(arg.earlier);
  cross(rigid.turning, arm, turned);
  P before[3];
  for (int i = 0; i < 3; ++i)
    before[i] = arm[i] - earlier * (turned[i] + speed[i] + speed[i]);
  cross(rigid.turning, before, velocity);
  for (int i = 0; i < 3; ++i)
    {
      const unsigned int at = (3 * node + i) * n_lanes + lane;
      (rigid.position[i] + arm[i]).store(arg.position + at);
      (rigid.velocity[i] + speed[i] + velocity[i]).store(arg.velocity + at);
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
  const double     *shape[count];
  P                 q_sum[count][3], rate_sum[count][3];
  for (int n = 0; n < count; ++n)
    {
      shape[n] =
          nodes.shape + static_cast<unsigned long>(nodes.orbit[first + n]) * 3 * nodes.n_modes;
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
            const P phi(shape[n][3 * m + d]);
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

/// Places the nodes of @p count orbits from number @p first on.
template <int width, int count, bool with_rate>
CHAINDRIVE_ALWAYS_INLINE void place_some(const PlaceArguments &arg,
                                         const Rigid<width>   &rigid,
                                         const int             lane,
                                         const unsigned int    first)
{
  using P                   = Pack<double, width>;
  const ModalNodes  &nodes  = arg.nodes;
  const unsigned int n_here = nodes.n_images;
  P                  u[most_images][count][3], s[most_images][count][3];
#pragma GCC unroll 1
  for (unsigned int c = 0; c < n_here; ++c)
    sum_of_class<width, count, with_rate>(arg, lane, first, c, u[c], s[c]);
  exchange_classes_and_images(&u[0][0][0], 3 * count, n_here);
  if (with_rate)
    exchange_classes_and_images(&s[0][0][0], 3 * count, n_here);

  const P per_step(1. / arg.step);
  for (int n = 0; n < count; ++n)
#pragma GCC unroll 1
    for (unsigned int g = 0; g < n_here; ++g)
      {
        const unsigned int i = (first + n) * n_here + g, node = nodes.node[i];
        if (node == ModalNodes::none)
          continue;
        P moved[3], speed[3];
        for (int d = 0; d < 3; ++d)
          {
            const P sign(nodes.sign[3 * g + d]);
            double *before = arg.displaced + (3 * i + d) * n_lanes + lane;
            moved[d]       = sign * u[g][n][d];
            speed[d] = sign * (with_rate ? s[g][n][d] : (u[g][n][d] - P::load(before)) * per_step);
            u[g][n][d].store(before);
          }
        place_node<width>(arg, rigid, lane, node, moved, speed);
      }
}

template <int width, int count, bool with_rate>
CHAINDRIVE_ALWAYS_INLINE void place_lanes(const PlaceArguments &arg, const int lane)
{
  const Rigid<width> rigid(arg.nodes.rigid, lane);
  unsigned int       i = 0;
#pragma GCC unroll 1
  for (; i + count <= arg.nodes.n_orbits; i += count)
    place_some<width, count, with_rate>(arg, rigid, lane, i);
#pragma GCC unroll 1
  for (; i < arg.nodes.n_orbits; ++i)
    place_some<width, 1, with_rate>(arg, rigid, lane, i);
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
  using P               = Pack<double, width>;
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
template <int width>
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
      P    f[most_images][3];
      bool any = false;
#pragma GCC unroll 1
      for (unsigned int g = 0; g < nodes.n_images; ++g)
        {
          for (int d = 0; d < 3; ++d)
            f[g][d] = P(0.);
          const unsigned int node = nodes.node[i * nodes.n_images + g];
          if (node != ModalNodes::none &&
              take_force<width>(arg, lane, node, rotation, centre, moment, f[g]))
            {
              any = true;
              for (int d = 0; d < 3; ++d)
                f[g][d] = P(nodes.sign[3 * g + d]) * f[g][d];
            }
        }
      if (!any)
        continue;
      exchange_classes_and_images(&f[0][0], 3, nodes.n_images);
#pragma GCC unroll 1
      for (unsigned int c = 0; c < nodes.n_images; ++c)
        for (int d = 0; d < 3; ++d)
          f[c][d].store(arg.in_body + ((n * nodes.n_images + c) * 3 + d) * n_lanes + lane);
      arg.found[n++] = nodes.orbit[i];
    }
  for (int d = 0; d < 3; ++d)
    moment[d].store(arg.moment + d * n_lanes + lane);
  return n;
}

/// The generalised forces of @p count modes of class @p c from @p first on.
template <int width, int count>
CHAINDRIVE_ALWAYS_INLINE void project_forces(const GatherArguments &arg,
                                             const int              lane,
                                             const unsigned int     n,
                                             const unsigned int     c,
                                             const unsigned int     first)
{
  using P = Pack<double, width>;
  P sum[count];
  for (int m = 0; m < count; ++m)
    sum[m] = P(0.);
#pragma GCC unroll 1
  for (unsigned int i = 0; i < n; ++i)
    {
      const double *shape =
          arg.nodes.shape +
          3 * (static_cast<unsigned long>(arg.found[i]) * arg.nodes.n_modes + first);
      P f[3];
      for (int d = 0; d < 3; ++d)
        f[d] = P::load(arg.in_body + ((i * arg.nodes.n_images + c) * 3 + d) * n_lanes + lane);
      for (int d = 0; d < 3; ++d)
#pragma GCC unroll 8
        for (int m = 0; m < count; ++m)
          sum[m] += P(shape[3 * m + d]) * f[d];
    }
  for (int m = 0; m < count; ++m)
    sum[m].store(arg.modal_force + (first + m) * n_lanes + lane);
}

template <int width>
CHAINDRIVE_ALWAYS_INLINE void gather_lanes(const GatherArguments &arg, const int lane)
{
  const unsigned int n = take_forces<width>(arg, lane);
#pragma GCC unroll 1
  for (unsigned int c = 0; c < arg.nodes.n_images; ++c)
    {
      unsigned int       m   = arg.nodes.first_mode[c];
      const unsigned int end = arg.nodes.first_mode[c + 1];
      for (; m + 8 <= end; m += 8)
        project_forces<width, 8>(arg, lane, n, c, m);
      for (; m + 4 <= end; m += 4)
        project_forces<width, 4>(arg, lane, n, c, m);
      for (; m < end; ++m)
        project_forces<width, 1>(arg, lane, n, c, m);
    }
}

/// As many orbits at a time as keep their sums in registers.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void place(const PlaceArguments &arg)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    if (arg.rate != nullptr)
      place_lanes<width, width == 8 ? 4 : 2, true>(arg, lane);
    else
      place_lanes<width, 4, false>(arg, lane);
}

template <int width>
CHAINDRIVE_ALWAYS_INLINE void gather(const GatherArguments &arg)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    gather_lanes<width>(arg, lane);
}
} // namespace chaindrive::packed
