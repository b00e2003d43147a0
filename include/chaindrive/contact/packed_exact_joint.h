// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of joint_kernels.h for joints without penalty, as in packed_joint.h: gaps
// of the nodes in the windows, and forces on them that somebody has found for all nodes of a joint.

#include <chaindrive/contact/packed_joint.h>

namespace chaindrive::contact::packed
{
/// The slave column that is @p place columns after the first of the window of a lane.
inline unsigned int column_of(const JointArguments &arg, const int lane, const unsigned int place)
{
  const unsigned int n = arg.grid->slave_circumferential, column = arg.window->first[lane] + place;
  return column < n ? column : column - n;
}

/// What measure_window() finds: the frames of the bores in front, then one meeting for each node;
/// lanes after lanes.
template <int width>
CHAINDRIVE_ALWAYS_INLINE Joints<width> &joints_of(const WindowNodes &nodes, const int lane)
{
  return reinterpret_cast<Joints<width> *>(nodes.met)[lane / width];
}

template <int width>
CHAINDRIVE_ALWAYS_INLINE Meeting<width>                          &
met_of(const WindowNodes &nodes, const int lane, const unsigned int node)
{
  constexpr int n_packs = n_lanes / width;
  char *const   first   = nodes.met + n_packs * sizeof(Joints<width>);
  return reinterpret_cast<Meeting<width> *>(first)[node * n_packs + lane / width];
}

template <int width>
std::size_t room(const std::size_t n_nodes)
{
  static_assert(sizeof(Joints<width>) % alignof(Meeting<width>) == 0,
                "what follows is not aligned");
  return n_lanes / width * (sizeof(Joints<width>) + n_nodes * sizeof(Meeting<width>));
}

/// Which nodes a visit has found, and where meet() has ended: from there it need not begin anew.
template <int width>
struct alignas(64) Known
{
  double       counts[width];   ///< 1 in lanes that have the node, 0 in others
  double       along[2][width]; ///< as meet_again() wants them
  double       area[width];     ///< m2
  unsigned int slave[width];    ///< offset
  unsigned int node[4][width];  ///< as in Meeting
  unsigned int state_at[width]; ///< where what the node remembers begins
  unsigned int cell_at[width], cell[width], ring_at[width], ring[width];
  unsigned int state; ///< 0: not known; 1: in some lane there is a node; 2: in none
  bool         active[width];
};

template <int width>
std::size_t known_room(const std::size_t n_nodes)
{
  return n_nodes * (n_lanes / width) * sizeof(Known<width>);
}

template <int width>
CHAINDRIVE_ALWAYS_INLINE Known<width>                          &
known_of(const WindowNodes &nodes, const int lane, const unsigned int node)
{
  return reinterpret_cast<Known<width> *>(nodes.known)[node * (n_lanes / width) + lane / width];
}

/// Makes visit number @p visit of the windows and notes what it finds. Returns false if no lane has
/// a node for it.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool visit_anew(const JointArguments &arg,
                                         const WindowNodes    &nodes,
                                         const int             lane,
                                         const Joints<width>  &joints,
                                         const unsigned int    visit,
                                         Known<width>         &known,
                                         Meeting<width>       &m)
{
  constexpr double   nowhere = 1e300;
  const JointGrid   &grid    = *arg.grid;
  const unsigned int n       = grid.slave_circumferential;
  unsigned int       index[width], cell[width], ring[width];
  bool               any = false;
  for (int l = 0; l < width; ++l)
    {
      const unsigned int node = nodes.order[visit * n_lanes + lane + l];
      known.active[l]         = joints.present[l] && node != WindowNodes::none;
      any |= known.active[l];
      const unsigned int at     = known.active[l] ? node : 0,
                         column = column_of(arg, lane + l, at / nodes.n_rings),
                         s      = nodes.ring[at % nodes.n_rings];
      index[l]                  = s * n + column;
      known.area[l]             = grid.area[s];
      known.state_at[l]         = index[l] * n_touch_entries * n_lanes + lane + l;
      known.cell_at[l]          = column * n_lanes + lane + l;
      known.ring_at[l]          = s * n_lanes + lane + l;
      cell[l]                   = arg.cell[known.cell_at[l]];
      ring[l]                   = arg.ring[known.ring_at[l]];
    }
  known.state = any ? 1 : 2;
  if (!any)
    return false;
  take_slave(joints, index, m);
  meet(grid, joints, cell, ring, m);
  for (int l = 0; l < width; ++l)
    {
      if (known.active[l]) // where others are, which are not announced, nobody knows
        {
          arg.cell[known.cell_at[l]] = cell[l];
          arg.ring[known.ring_at[l]] = ring[l];
        }
      known.counts[l]   = known.active[l] ? 1. : 0.;
      known.slave[l]    = joints.slave_node[l][index[l]];
      known.cell[l]     = arg.cell[known.cell_at[l]];
      known.ring[l]     = arg.ring[known.ring_at[l]];
      known.along[0][l] = known.ring[l] == 0 ? -nowhere : -side_tolerance;
      known.along[1][l] = known.ring[l] + 2 == grid.master_rings ? nowhere : 1. + side_tolerance;
      for (int q = 0; q < 4; ++q)
        known.node[q][l] = m.node[q][l];
    }
  return true;
}

/// The same for a node that is known, with the same result to the last bit. Returns false where
/// visit_anew() must find it out.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool visit_again(const JointArguments &arg,
                                          const Joints<width>  &joints,
                                          const Known<width>   &known,
                                          Meeting<width>       &m)
{
  using P      = Pack<double, width>;
  bool differs = false; // other rings of the column have ended elsewhere
  for (int l = 0; l < width; ++l)
    {
      differs |= known.active[l] && (arg.cell[known.cell_at[l]] != known.cell[l] ||
                                     arg.ring[known.ring_at[l]] != known.ring[l]);
      m.slave[l] = joints.slave_position[l] + known.slave[l];
      for (int q = 0; q < 4; ++q)
        m.node[q][l] = known.node[q][l];
    }
  P x[3];
  for (int i = 0; i < 3; ++i)
    x[i] = gather(m.slave, i * n_lanes) - joints.origin[i];
  into_frame(joints.axes, x, m.x);
  const P along[2] = {P::load(known.along[0]), P::load(known.along[1])};
  if (!meet_again(*arg.grid, joints, P::load(known.counts), along, differs, m))
    return false;
  for (int l = 0; l < width && differs; ++l)
    if (known.active[l])
      {
        arg.cell[known.cell_at[l]] = known.cell[l];
        arg.ring[known.ring_at[l]] = known.ring[l];
      }
  return true;
}

template <int width>
void measure_window_of(const JointArguments &arg, const WindowNodes &nodes, const int lane)
{
  Joints<width> &joints = joints_of<width>(nodes, lane);
  if (!take_lanes(arg, lane, joints))
    return;
  if (nodes.n_visits == 0)
    return;
  find_frame(*arg.grid, joints);
#pragma GCC unroll 1
  for (unsigned int visit = 0; visit < nodes.n_visits; ++visit)
    {
      Known<width>   &known = known_of<width>(nodes, lane, visit);
      Meeting<width> &met   = met_of<width>(nodes, lane, visit);
      if (known.state == 2)
        continue;
      if (known.state == 0 || !visit_again(arg, joints, known, met))
        if (!visit_anew(arg, nodes, lane, joints, visit, known, met))
          continue;
      double *gap = nodes.gap + visit * n_lanes + lane;
      for (int l = 0; l < width; ++l)
        gap[l] = known.active[l] ? met.gap[l] : 1.;
    }
}

/// A normal force as that of a law of unit stiffness: its energy is booked for the whole joint.
template <typename Number>
struct GivenForce
{
  Number force; ///< N
  Number rate;  ///< which the law has no damping for

  CHAINDRIVE_ALWAYS_INLINE Number penetration() const { return force; }

  CHAINDRIVE_ALWAYS_INLINE Number spring(const scene::ContactLawOf<Number> &law,
                                         const Number                       d) const
  {
    return law.stiffness * d;
  }

  template <int n_tangents>
  CHAINDRIVE_ALWAYS_INLINE void book(const scene::ContactLawOf<Number> &,
                                     const TouchStateOf<Number, n_tangents> &,
                                     const TouchStateOf<Number, n_tangents> &,
                                     const Number /*dt*/,
                                     ContactEnergies<Number> &) const
  {
  }
};

template <int width>
void press_of(const JointArguments &arg, const WindowNodes &nodes, const int lane)
{
  using P         = Pack<double, width>;
  JointSums &sums = *arg.sums;
  clear_sums<width>(lane, sums);
  if (nodes.n_pressed == 0)
    return;
  const Joints<width> &joints = joints_of<width>(nodes, lane);
  const P              zero(0.);
  ContactEnergies<P>   energies{zero, zero, zero};
  P                    total[3] = {zero, zero, zero};
#pragma GCC unroll 1
  for (unsigned int i = 0; i < nodes.n_pressed; ++i)
    {
      const Known<width> &known = known_of<width>(nodes, lane, nodes.pressed[i]);
      if (known.state == 2)
        continue;
      const double *given                  = nodes.force + nodes.pressed[i] * n_lanes + lane;
      const unsigned int(&state_at)[width] = known.state_at;
      bool changes[width], any = false;
      for (int l = 0; l < width; ++l)
        {
          changes[l] = known.active[l] &&
                       (given[l] > 0. || arg.state[state_at[l] + touch_penetration * n_lanes] > 0.);
          any |= changes[l];
        }
      if (!any)
        continue;
      const Meeting<width> &m = met_of<width>(nodes, lane, nodes.pressed[i]);
      alignas(64) double    in[n_touch_entries + 1][width];
      for (int l = 0; l < width; ++l)
        {
          for (unsigned int entry = 0; entry < n_touch_entries; ++entry)
            in[entry][l] = changes[l] ? arg.state[state_at[l] + entry * n_lanes] : 0.;
          in[n_touch_entries][l] = changes[l] ? given[l] : 0.;
        }
      TouchStateOf<P> touch{
          P::load(in[touch_penetration]),
          P::load(in[touch_normal]),
          {P::load(in[touch_slip_around]), P::load(in[touch_slip_along])},
          {P::load(in[touch_tangential_around]), P::load(in[touch_tangential_along])}};
      Motion<P> motion;
      find_motion(joints, m, motion);
      const P                      slip_rate[2] = {motion.relative[1] - motion.arm * motion.spin,
                                                   motion.relative[2] - motion.arm * motion.tilt};
      const P                      area         = P::load(known.area);
      const scene::ContactLawOf<P> law{P(1.),
                                       zero,
                                       P(arg.law.friction),
                                       area * P(arg.law.tangential_stiffness),
                                       area * P(arg.law.tangential_damping)};
      update_touch(law,
                   GivenForce<P>{P::load(in[n_touch_entries]), zero},
                   slip_rate,
                   P(arg.dt),
                   arg.law.friction > 0.,
                   touch,
                   energies);
      // forces are the derivatives of the energy: gaps change along a bore that is not round
      const P *first = m.corner[0], *second = m.corner[1];
      const P  farther = second[0] * second[0] + second[1] * second[1] - first[0] * first[0] -
                        first[1] * first[1],
              side = square_root(motion.side[0] * motion.side[0] + motion.side[1] * motion.side[1]);
      const P slope[2] = {farther / ((m.radius + m.radius) * side),
                          motion.rise[0] / motion.rise[1]};
      apply_touch(arg, lane, joints, m, motion, state_at, changes, touch, total, slope);
    }
  for (int l = 0; l < width; ++l)
    {
      sums.stored[lane + l] = energies.stored[l];
      for (int i = 0; i < 3; ++i)
        sums.force[i][lane + l] = total[i][l];
      sums.friction_loss[lane + l] += energies.friction_loss[l];
    }
}

template <int width>
void measure_window(const JointArguments &arg, const WindowNodes &nodes)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    measure_window_of<width>(arg, nodes, lane);
}

template <int width>
void press(const JointArguments &arg, const WindowNodes &nodes)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    press_of<width>(arg, nodes, lane);
}

template <int width>
constexpr JointKernels make_joint_kernels()
{
  return {width,
          add_forces<width>,
          measure_gaps<width>,
          measure_window<width>,
          room<width>,
          known_room<width>,
          press<width>};
}
} // namespace chaindrive::contact::packed
