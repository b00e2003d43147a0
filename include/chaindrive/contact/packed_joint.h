// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of joint_kernels.h, for `width` joints at a time: lane l of a pack is joint
// l, with its own two bodies, its own window of slave columns and its own nodes.
//
// For each ring of slave nodes, one column of the window after the other:
//   visit()         finds the gap of a node, see packed_geometry.h
//   add_share()   from its gap and those of its two neighbours in the ring, the mean penetration of
//                   the surface that the node stands for: forces are smooth functions of where the
//                   nodes are, as they would not be if each of few nodes touched by itself
//   touch_nodes()   the law, see penalty.h, with stiffness and damping of the node's area; then
//   scatter()       forces to the slave node and to four nodes of the bore.
// Lanes of one pack that have nothing to do compute with the numbers of others and write nothing.

#include <chaindrive/contact/packed_geometry.h>
#include <chaindrive/contact/penalty.h>

namespace chaindrive::contact::packed
{
/// A vector in the bore's frame in world axes.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void out_of_frame(const P (&axes)[3][3], const P (&y)[3], P (&x)[3])
{
  for (int i = 0; i < 3; ++i)
    x[i] = axes[0][i] * y[0] + axes[1][i] * y[1] + axes[2][i] * y[2];
}

/// Adds the forces of the pairs that touch, lane after lane: two lanes may share a body. @p
/// friction is that on the slave node round the bore and along it.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void scatter(const JointArguments              &arg,
                                      const int                          lane,
                                      const Joints<width>               &joints,
                                      const Meeting<width>              &m,
                                      const Motion<Pack<double, width>> &motion,
                                      const Pack<double, width> (&force)[3],
                                      const Pack<double, width> (&friction)[2],
                                      const bool (&touches)[width])
{
  using P = Pack<double, width>;
  // Friction T acts on the bore nearer to the axis than on the slave node, by the arm r - p. Pairs
  // of opposite forces on the two columns (moment T_round arm about the axis: force T arm / |side|
  // across the side) and on the two rings (the same along the axis) make up for its moment, and so
  // the resultant forces and moments of both bodies cancel. Their work is that of the turns (spin,
  // tilt) which slip_rate takes away.
  const P square_side         = motion.side[0] * motion.side[0] + motion.side[1] * motion.side[1],
          square_rise         = motion.rise[0] * motion.rise[0] + motion.rise[1] * motion.rise[1];
  const P round               = friction[0] * motion.arm / square_side,
          along               = friction[1] * motion.arm / square_rise;
  const P columns_in_frame[3] = {round * motion.side[1], P(0.) - round * motion.side[0], P(0.)};
  const P rings_in_frame[3]   = {along * motion.rise[1] * motion.ray[0],
                                 along * motion.rise[1] * motion.ray[1],
                                 P(0.) - along * motion.rise[0]};
  P       columns[3], rings[3];
  out_of_frame(joints.axes, columns_in_frame, columns);
  out_of_frame(joints.axes, rings_in_frame, rings);

  alignas(64) double part[5][3][width];
  for (int i = 0; i < 3; ++i)
    {
      const P second = P(0.) - m.around * force[i], first = P(0.) - force[i] - second;
      const P corner[2] = {first - columns[i], second + columns[i]};
      const P ring[2]   = {rings[i] - m.around * rings[i], m.around * rings[i]};
      for (int c = 0; c < 2; ++c)
        {
          const P upper = m.along[c] * corner[c];
          (upper + ring[c]).store(part[c + 2][i]);
          (corner[c] - upper - ring[c]).store(part[c][i]);
        }
      force[i].store(part[4][i]);
    }
  for (int l = 0; l < width; ++l)
    if (touches[l])
      {
        for (int q = 0; q < 4; ++q)
          {
            double *f = arg.master_force[lane + l] + m.node[q][l];
            for (int i = 0; i < 3; ++i)
              f[i * n_lanes] += part[q][i][l];
            if (arg.master_pressed[lane + l] != nullptr)
              arg.master_pressed[lane + l][m.node[q][l] / (3 * n_lanes)] = 1;
          }
        const unsigned long slave = m.slave[l] - joints.slave_position[l];
        double             *f     = arg.slave_force[lane + l] + slave;
        for (int i = 0; i < 3; ++i)
          f[i * n_lanes] += part[4][i][l];
        if (arg.slave_pressed[lane + l] != nullptr)
          arg.slave_pressed[lane + l][slave / (3 * n_lanes)] = 1;
      }
}

/// What the force kernel finds of one call begins with nothing in the lanes of a pack.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void clear_sums(const int lane, JointSums &sums)
{
  for (int l = lane; l < lane + width; ++l)
    {
      sums.stored[l] = sums.largest_penetration[l] = 0.;
      sums.touching[l]                             = 0;
      for (auto &component : sums.force)
        component[l] = 0.;
    }
}

/// After update_touch(): what the slave nodes of the lanes that have something to do, @p changes,
/// remember from now on, at @p state_at, and their forces on both sides, which @p total sums up.
/// @p slope is that of the bore round its axis and along it: a normal force acts across it.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void apply_touch(const JointArguments              &arg,
                                          const int                          lane,
                                          const Joints<width>               &joints,
                                          const Meeting<width>              &m,
                                          const Motion<Pack<double, width>> &motion,
                                          const unsigned int (&state_at)[width],
                                          const bool (&changes)[width],
                                          const TouchStateOf<Pack<double, width>> &touch,
                                          Pack<double, width> (&total)[3],
                                          const Pack<double, width> (&slope)[2])
{
  using P = Pack<double, width>;
  const P            zero(0.);
  alignas(64) double now[n_touch_entries][width];
  touch.penetration.store(now[touch_penetration]);
  touch.normal.store(now[touch_normal]);
  touch.slip[0].store(now[touch_slip_around]);
  touch.slip[1].store(now[touch_slip_along]);
  touch.tangential[0].store(now[touch_tangential_around]);
  touch.tangential[1].store(now[touch_tangential_along]);
  bool touches[width];
  for (int l = 0; l < width; ++l)
    {
      if (changes[l])
        for (unsigned int entry = 0; entry < n_touch_entries; ++entry)
          arg.state[state_at[l] + entry * n_lanes] = now[entry][l];
      touches[l] = changes[l] && now[touch_normal][l] > 0.;
      arg.sums->touching[lane + l] += touches[l];
    }

  const P(&e)[2]        = motion.ray;
  const P tangential[2] = {touch.tangential[0] + touch.normal * slope[0],
                           touch.tangential[1] + touch.normal * slope[1]};
  const P local[3]      = {zero - touch.normal * e[0] - tangential[0] * e[1],
                           tangential[0] * e[0] - touch.normal * e[1],
                           tangential[1]};
  P       force[3];
  out_of_frame(joints.axes, local, force);
  for (int i = 0; i < 3; ++i)
    total[i] += force[i];
  scatter(arg, lane, joints, m, motion, force, tangential, touches);
}

/// One slave node per lane and how it meets the bore. A gap that counts nowhere is a metre.
template <int width>
struct Visit
{
  using P = Pack<double, width>;

  Meeting<width> meeting;
  unsigned int   column[width];
  P              active; ///< 1, or 0 where the node is not in the lane's window
  P              cover;  ///< see covered()
  P              penetration_before;
  P              gap; ///< m
};

/// Where slave nodes of ring @p s meet the bore. From here the search begins next time in the lanes
/// that it @p is_for; of others nobody knows where their nodes are, since they are not announced.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void meet_and_remember(const JointArguments &arg,
                                                const int             lane,
                                                const Joints<width>  &joints,
                                                const unsigned int    s,
                                                const unsigned int (&column)[width],
                                                const bool (&is_for)[width],
                                                Meeting<width> &m)
{
  unsigned int *const rings = arg.ring + s * n_lanes + lane;
  unsigned int        cell[width], ring[width];
  for (int l = 0; l < width; ++l)
    {
      cell[l] = arg.cell[column[l] * n_lanes + lane + l];
      ring[l] = rings[l];
    }
  meet(*arg.grid, joints, cell, ring, m);
  for (int l = 0; l < width; ++l)
    if (is_for[l])
      {
        arg.cell[column[l] * n_lanes + lane + l] = cell[l];
        rings[l]                                 = ring[l];
      }
}

/// Visits the slave nodes of ring @p s that are @p place columns after the first of the windows.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void visit(const JointArguments &arg,
                                    const int             lane,
                                    const Joints<width>  &joints,
                                    const unsigned int    s,
                                    const unsigned int    place,
                                    Visit<width>         &v)
{
  using P                   = Pack<double, width>;
  const JointGrid   &grid   = *arg.grid;
  const JointWindow &window = *arg.window;
  unsigned int       index[width];
  const double      *penetration[width];
  alignas(64) double exists[width], active[width];
  for (int l = 0; l < width; ++l)
    {
      const unsigned int count  = joints.present[l] ? window.count[lane + l] : 0;
      const unsigned int column = window.first[lane + l] + place;
      v.column[l] =
          column < grid.slave_circumferential ? column : column - grid.slave_circumferential;
      index[l] = s * grid.slave_circumferential + v.column[l];
      penetration[l] =
          arg.state + (index[l] * n_touch_entries + touch_penetration) * n_lanes + lane + l;
      active[l] = place < count ? 1. : 0.;
      exists[l] = place < count || count == grid.slave_circumferential ? 1. : 0.;
    }
  take_slave(joints, index, v.meeting);
  const P depth        = depth_inside(grid, joints, v.meeting, grid.cover[s]);
  v.active             = P::load(active);
  v.cover              = v.active * covered(depth);
  v.penetration_before = v.active * gather(penetration, 0);
  v.gap                = P(1.);
  // A neighbour of a node that is just inside may be just outside, but not far: the bore is tilted
  // by less than 0.02. Its gap counts nevertheless, and whether it does must not depend on other
  // lanes.
  const P counts = if_less(P(-0.1), depth, P::load(exists), P(0.)) + v.penetration_before;
  if (!any_less(P(0.), counts))
    return;
  bool counts_here[width];
  for (int l = 0; l < width; ++l)
    counts_here[l] = counts[l] > 0.;
  meet_and_remember(arg, lane, joints, s, v.column, counts_here, v.meeting);
  v.gap = if_less(P(0.), counts, v.meeting.gap, P(1.));
}

/// Between two neighbouring columns the penetration is linear, from a at the first one to b at the
/// other; negative is a gap. Of what lies there the first column has the share of its hat function,
/// 1 - x at the part x of the way. Adds that of the penetration where there is one, the integral of
/// max(0, a + (b - a) x) (1 - x), and of the area that overlaps, the integral of 1 - x:
///
///   a, b > 0       (2 a + b) / 6          1/2
///   a > 0 > b      a t (3 - t) / 6        t (2 - t) / 2      t = a / (a - b)
///   b > 0 > a      b t^2 / 6              t^2 / 2            t = b / (b - a)
///
/// With both neighbours these sum up to the means over the area that the node stands for.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void
add_share(const P gap, const P neighbours_gap, P &penetration, P &penetrating)
{
  const P zero(0.), half(0.5), sixth(1. / 6.);
  const P a = zero - gap, b = zero - neighbours_gap;
  const P high = greatest(a, b), low = least(a, b), positive = greatest(zero, high);
  // t: the part of the way from the higher one to the lower one on which there is penetration
  const P t      = positive / greatest(high - low, P(1e-300));
  const P nearer = half * t * (P(2.) - t), farther = half * t * t;
  const P both = sixth * (a + a + b);
  const P one  = sixth * positive * if_less(a, b, t * t, t * (P(3.) - t));
  penetration += if_less(low, zero, one, both);
  penetrating += if_less(low, zero, if_less(a, b, farther, nearer), half);
}

/// Contact forces of the nodes of one visit. @p penetration and @p penetrating as add_share() gives
/// them.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void touch_nodes(const JointArguments                 &arg,
                                          const int                             lane,
                                          const Joints<width>                  &joints,
                                          const unsigned int                    s,
                                          const Visit<width>                   &v,
                                          const Pack<double, width>             penetration,
                                          const Pack<double, width>             penetrating,
                                          ContactEnergies<Pack<double, width>> &energies,
                                          Pack<double, width> (&total)[3])
{
  using P               = Pack<double, width>;
  const JointGrid &grid = *arg.grid;
  const P          zero(0.);
  unsigned int     state_at[width];
  const double    *state[width];
  for (int l = 0; l < width; ++l)
    {
      state_at[l] =
          (s * grid.slave_circumferential + v.column[l]) * n_touch_entries * n_lanes + lane + l;
      state[l] = arg.state + state_at[l];
    }
  TouchStateOf<P> touch{v.penetration_before,
                        v.active * gather(state, touch_normal * n_lanes),
                        {v.active * gather(state, touch_slip_around * n_lanes),
                         v.active * gather(state, touch_slip_along * n_lanes)},
                        {v.active * gather(state, touch_tangential_around * n_lanes),
                         v.active * gather(state, touch_tangential_along * n_lanes)}};

  Motion<P> motion;
  find_motion(joints, v.meeting, motion);
  // turning together with the bore is no slip: its material at the slave node's place moves with it
  const P slip_rate[2] = {motion.relative[1] - motion.arm * motion.spin,
                          motion.relative[2] - motion.arm * motion.tilt};

  const P                      share = v.cover * P(grid.area[s]), dt(arg.dt);
  const scene::ContactLawOf<P> law{share * P(arg.law.stiffness),
                                   share * penetrating * P(arg.law.damping),
                                   P(arg.law.friction),
                                   share * P(arg.law.tangential_stiffness),
                                   share * P(arg.law.tangential_damping)};
  const NodeApproach<P>        approach{
      penetration, v.gap, zero - motion.relative[0], dt * motion.relative[0]};
  update_touch(law, approach, slip_rate, dt, arg.law.friction > 0., touch, energies);

  const P now_or_before = touch.penetration + v.penetration_before;
  bool    changes[width];
  for (int l = 0; l < width; ++l)
    changes[l] = now_or_before[l] > 0.;
  const P along_ray[2] = {zero, zero};
  apply_touch(arg, lane, joints, v.meeting, motion, state_at, changes, touch, total, along_ray);
}

/// Contact forces of the joints in lanes @p lane to lane + width - 1.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void add_forces_of(const JointArguments &arg, const int lane)
{
  using P               = Pack<double, width>;
  const JointGrid &grid = *arg.grid;
  JointSums       &sums = *arg.sums;
  clear_sums<width>(lane, sums);

  Joints<width> joints;
  if (!take_lanes(arg, lane, joints))
    return;
  unsigned int visits = 0;
  for (int l = 0; l < width; ++l)
    if (joints.present[l] && arg.window->count[lane + l] > visits)
      visits = arg.window->count[lane + l];
  if (visits == 0)
    return;
  const bool closed = visits == grid.slave_circumferential;
  find_frame(grid, joints);

  const P            zero(0.);
  ContactEnergies<P> energies{zero, zero, zero};
  P                  total[3] = {zero, zero, zero}, largest_penetration(0.);

#pragma GCC unroll 1
  for (unsigned int s = 0; s < grid.slave_rings; ++s)
    {
      // Visit i is that of the node i - 1 places after the window's first; the forces of a node
      // follow the visit of the next one. A window all round begins and ends with a neighbour.
      Visit<width> visited[2];
      P            gap_before(1.);
      visited[0].gap = P(1.);
#pragma GCC unroll 1
      for (unsigned int i = closed ? 0 : 1; i < visits + 2; ++i)
        {
          Visit<width> &next = visited[i % 2], &v = visited[(i + 1) % 2];
          const bool    beyond = i == visits + 1;
          if (beyond && !closed)
            next.gap = P(1.);
          else
            visit(arg, lane, joints, s, i == 0 ? visits - 1 : beyond ? 0 : i - 1, next);

          if (i >= 2)
            {
              P penetration(0.), penetrating(0.);
              add_share(v.gap, gap_before, penetration, penetrating);
              add_share(v.gap, next.gap, penetration, penetrating);
              penetration = if_less(zero, v.cover, penetration, zero);
              if (any_less(zero, penetration + v.penetration_before))
                {
                  touch_nodes(arg, lane, joints, s, v, penetration, penetrating, energies, total);
                  largest_penetration =
                      greatest(largest_penetration, if_less(zero, penetration, zero - v.gap, zero));
                }
            }
          gap_before = v.gap;
        }
    }

  for (int l = 0; l < width; ++l)
    {
      sums.stored[lane + l]              = energies.stored[l];
      sums.largest_penetration[lane + l] = largest_penetration[l];
      for (int i = 0; i < 3; ++i)
        sums.force[i][lane + l] = total[i][l];
      sums.damping_loss[lane + l] += energies.damping_loss[l];
      sums.friction_loss[lane + l] += energies.friction_loss[l];
    }
}

/// Whether somebody asks for column @p c of the slaves in lanes @p lane to lane + width - 1.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool
take_wanted(const GapArguments &gaps, const int lane, const unsigned int c, bool (&wanted)[width])
{
  bool any = false;
  for (int l = 0; l < width; ++l)
    {
      wanted[l] = gaps.wanted[c * n_lanes + lane + l] != 0;
      any |= wanted[l];
    }
  return any;
}

/// Gaps of slave nodes of the joints in lanes @p lane to lane + width - 1.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void
measure_gaps_of(const JointArguments &arg, GapArguments &gaps, const int lane)
{
  using P               = Pack<double, width>;
  const JointGrid &grid = *arg.grid;
  Joints<width>    joints;
  for (int l = 0; l < width; ++l)
    gaps.closing[lane + l] = 0.;
  if (!take_lanes(arg, lane, joints))
    return;
  find_frame(grid, joints);

  P closing(0.);
#pragma GCC unroll 1
  for (unsigned int s = grid.first_ring; s < grid.end_ring; ++s)
#pragma GCC unroll 1
    for (unsigned int c = 0; c < grid.slave_circumferential; ++c)
      {
        Meeting<width> m;
        unsigned int   index[width], column[width];
        bool           wanted[width];
        if (!take_wanted(gaps, lane, c, wanted))
          continue;
        for (int l = 0; l < width; ++l)
          {
            index[l]  = s * grid.slave_circumferential + c;
            column[l] = c;
            wanted[l] = wanted[l] && joints.present[l];
          }
        take_slave(joints, index, m);
        meet_and_remember(arg, lane, joints, s, column, wanted, m);
        const P depth = covered(depth_inside(grid, joints, m, grid.cover[s]));
        for (int l = 0; l < width; ++l)
          if (wanted[l])
            {
              gaps.gap[index[0] * n_lanes + lane + l]     = m.gap[l];
              gaps.covered[index[0] * n_lanes + lane + l] = depth[l];
            }
        if (!gaps.wants_closing)
          continue;
        Motion<P> motion;
        find_motion(joints, m, motion);
        closing = greatest(closing, motion.relative[0]);
      }
  for (int l = 0; l < width; ++l)
    gaps.closing[lane + l] = joints.present[l] ? closing[l] : 0.;
}

template <int width>
void add_forces(const JointArguments &arg)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    add_forces_of<width>(arg, lane);
}

template <int width>
void measure_gaps(const JointArguments &arg, GapArguments &gaps)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    measure_gaps_of<width>(arg, gaps, lane);
}
} // namespace chaindrive::contact::packed
