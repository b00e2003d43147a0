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

/// Places one node that the shapes move by @p u with the speed @p s, both in body axes.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void place_node(const PlaceArguments &arg,
                                         const int             lane,
                                         const unsigned int    node,
                                         const Pack<double, width> (&u)[3],
                                         const Pack<double, width> (&s)[3])
{
  using P = Pack<double, width>;
  P rotation[9], turning[3], arm[3], speed[3], turned[3], velocity[3];
  load_rigid(arg.nodes.rigid, rigid_rotation, lane, rotation);
  load_rigid(arg.nodes.rigid, rigid_turning, lane, turning);
  P y[3];
  for (int i = 0; i < 3; ++i)
    y[i] = P(arg.nodes.reference[3 * node + i]) + u[i];
  for (int i = 0; i < 3; ++i)
    {
      arm[i]   = rotation[3 * i] * y[0] + rotation[3 * i + 1] * y[1] + rotation[3 * i + 2] * y[2];
      speed[i] = rotation[3 * i] * s[0] + rotation[3 * i + 1] * s[1] + rotation[3 * i + 2] * s[2];
    }
  const P earlier(arg.earlier);
  cross(turning, arm, turned);
  P before[3];
  for (int i = 0; i < 3; ++i)
    before[i] = arm[i] - earlier * (turned[i] + speed[i] + speed[i]);
  cross(turning, before, velocity);
  for (int i = 0; i < 3; ++i)
    {
      const unsigned int at = (3 * node + i) * n_lanes + lane;
      (P::load(arg.nodes.rigid + (rigid_position + i) * n_lanes + lane) + arm[i])
          .store(arg.position + at);
      (P::load(arg.nodes.rigid + (rigid_velocity + i) * n_lanes + lane) + speed[i] + velocity[i])
          .store(arg.velocity + at);
    }
}

/// The displacements of @p count nodes from number @p first on, and their speeds if @p with_rate,
/// so that each load of q serves all.
template <int width, int count, bool with_rate>
CHAINDRIVE_ALWAYS_INLINE void
place_some(const PlaceArguments &arg, const int lane, const unsigned int first)
{
  using P                 = Pack<double, width>;
  const ModalNodes &nodes = arg.nodes;
  const double     *shape[count];
  P                 u[count][3], s[count][3];
  for (int n = 0; n < count; ++n)
    {
      shape[n] =
          nodes.shape + static_cast<unsigned long>(nodes.node[first + n]) * 3 * nodes.n_modes;
      for (int d = 0; d < 3; ++d)
        u[n][d] = s[n][d] = P(0.);
    }
#pragma GCC unroll 1
  for (unsigned int m = 0; m < nodes.n_modes; ++m)
    {
      const P q = P::load(arg.amplitude + m * n_lanes + lane);
      P       rate(0.);
      if (with_rate)
        rate = P::load(arg.rate + m * n_lanes + lane);
      for (int n = 0; n < count; ++n)
        for (int d = 0; d < 3; ++d)
          {
            const P phi(shape[n][3 * m + d]);
            u[n][d] += phi * q;
            if (with_rate)
              s[n][d] += phi * rate;
          }
    }
  const P per_step(1. / arg.step);
  for (int n = 0; n < count; ++n)
    {
      if (arg.displaced != nullptr)
        for (int d = 0; d < 3; ++d)
          {
            double *before = arg.displaced + (3 * (first + n) + d) * n_lanes + lane;
            if (!with_rate)
              s[n][d] = (u[n][d] - P::load(before)) * per_step;
            u[n][d].store(before);
          }
      place_node<width>(arg, lane, nodes.node[first + n], u[n], s[n]);
    }
}

template <int width, int count, bool with_rate>
CHAINDRIVE_ALWAYS_INLINE void place_lanes(const PlaceArguments &arg, const int lane)
{
  unsigned int i = 0;
#pragma GCC unroll 1
  for (; i + count <= arg.nodes.n_nodes; i += count)
    place_some<width, count, with_rate>(arg, lane, i);
#pragma GCC unroll 1
  for (; i < arg.nodes.n_nodes; ++i)
    place_some<width, 1, with_rate>(arg, lane, i);
}

/// Lists the nodes on which a force acts in any lane, with that force in body axes, and sums up the
/// couples. Returns their number.
template <int width>
CHAINDRIVE_ALWAYS_INLINE unsigned int take_forces(const GatherArguments &arg, const int lane)
{
  using P = Pack<double, width>;
  P rotation[9], centre[3], moment[3] = {P(0.), P(0.), P(0.)};
  load_rigid(arg.nodes.rigid, rigid_rotation, lane, rotation);
  load_rigid(arg.nodes.rigid, rigid_position, lane, centre);
  unsigned int n = 0;
#pragma GCC unroll 1
  for (unsigned int i = 0; i < arg.nodes.n_nodes; ++i)
    {
      const unsigned int at = 3 * arg.nodes.node[i] * n_lanes + lane;
      P                  f[3], arm[3], couple[3];
      for (int d = 0; d < 3; ++d)
        f[d] = P::load(arg.force + at + d * n_lanes);
      if (!any_less(P(0.), f[0] * f[0] + f[1] * f[1] + f[2] * f[2]))
        continue;
      for (int d = 0; d < 3; ++d)
        {
          P(0.).store(arg.force + at + d * n_lanes);
          arm[d] = P::load(arg.position + at + d * n_lanes) - centre[d];
        }
      cross(arm, f, couple);
      for (int d = 0; d < 3; ++d)
        {
          moment[d] += couple[d];
          (rotation[d] * f[0] + rotation[3 + d] * f[1] + rotation[6 + d] * f[2])
              .store(arg.in_body + (3 * n + d) * n_lanes + lane);
        }
      arg.found[n++] = arg.nodes.node[i];
    }
  for (int d = 0; d < 3; ++d)
    moment[d].store(arg.moment + d * n_lanes + lane);
  return n;
}

/// The generalised forces of @p count modes from @p first on.
template <int width, int count>
CHAINDRIVE_ALWAYS_INLINE void project_forces(const GatherArguments &arg,
                                             const int              lane,
                                             const unsigned int     n,
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
        f[d] = P::load(arg.in_body + (3 * i + d) * n_lanes + lane);
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
  const unsigned int n = take_forces<width>(arg, lane), n_modes = arg.nodes.n_modes;
  unsigned int       m = 0;
  for (; m + 8 <= n_modes; m += 8)
    project_forces<width, 8>(arg, lane, n, m);
  for (; m + 4 <= n_modes; m += 4)
    project_forces<width, 4>(arg, lane, n, m);
  for (; m < n_modes; ++m)
    project_forces<width, 1>(arg, lane, n, m);
}

/// As many nodes at a time as keep their sums in registers.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void place(const PlaceArguments &arg)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    if (arg.rate != nullptr)
      place_lanes<width, 2, true>(arg, lane);
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
