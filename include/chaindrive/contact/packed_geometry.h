// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Where the nodes of a cylinder, the slaves, meet a bore, the master; for `width` joints at a time.
//
// The bore's frame: its axis e_3 runs from the centre o of the bore's first ring of nodes to that
// of its last one, over the length l; e_1 points from the axis to the first column of nodes, e_2 =
// e_3 x e_1. A slave node is at x in this frame, at the distance r = |(x_1, x_2)| from the axis, on
// the ray e = (x_1, x_2) / r.
//
// Each column of master nodes is a line from one ring to the next. It passes the plane of the slave
// node, x_3 = const, in one point
//
//   a_c = (1 - s_c) a_lower + s_c a_upper,      s_c = (x_3 - a_lower,3) / (a_upper,3 - a_lower,3).
//
// Such points of neighbouring columns are the corners of a polygon. The ray passes its side from
// a_0 to a_1 where the cross products a_0 x e and e x a_1 are not negative, at the part
//
//   t = (a_0 x e) / (a_0 x e + e x a_1)
//
// of the way, at the distance p = (a_0 + t (a_1 - a_0)) . e from the axis. The bore is round and
// not a polygon: of n columns, undeformed and of the radius R, a side has the length 2 R sin(pi /
// n), and its point at t is sqrt(1 - 4 sin^2(pi / n) t (1 - t)) R from the axis. By what that is
// less than R the bore lies outside the polygon, deformed or not:
//
//   g = p + R (1 - sqrt(1 - 4 sin^2(pi / n) t (1 - t))) - r.
//
// The force on the slave node is carried by the four nodes about the side's point, with the weights
// (1 - t or t) (1 - s or s).

#include <chaindrive/contact/joint_kernels.h>

namespace chaindrive::contact::packed
{
/// The joints of a pack: its lanes' pointers, and the frame of each bore.
template <int width>
struct Joints
{
  using P = Pack<double, width>;

  bool                present[width];
  const unsigned int *master_node[width], *slave_node[width];
  const double       *master_position[width], *slave_position[width];
  const double       *master_velocity[width], *slave_velocity[width];

  P origin[3];  ///< centre of the bore's first ring, m
  P axes[3][3]; ///< orthonormal; the first points to the first column, the third along the axis
  P length;     ///< from the first ring's centre to that of the last, m
};

/// Where the ray from the bore's axis through a slave node meets the bore. A column of master nodes
/// passes the plane of the slave node, which is normal to the axis, in one point: these points are
/// the corners of a polygon, and the ray meets one of its sides.
template <int width>
struct Meeting
{
  using P = Pack<double, width>;

  const double *slave[width];   ///< the slave node's position
  unsigned int  node[4][width]; ///< offsets of master nodes: two columns of the first ring, then of
                                ///< the second
  P x[3];                       ///< the slave node in the bore's frame, m
  P radius;                     ///< r: its distance from the axis, m
  P along[2];                   ///< s: where between the two rings the columns pass the plane
  P around;                     ///< t: where between the two corners the ray passes
  P corner[2][2];               ///< the two corners a: column, component; m
  P rise[2][3];                 ///< of a column from one ring to the next: column, component; m
  P chord;                      ///< p: distance of the point where the ray passes from the axis, m
  P gap;                        ///< g, m
};

/// Copies the pointers of the lanes from @p lane on. Lanes without a joint read the numbers of
/// one that has one. Returns false if there is none.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool
take_lanes(const JointArguments &arg, const int lane, Joints<width> &joints)
{
  int valid_lane = -1;
  for (int l = 0; l < width; ++l)
    {
      joints.present[l] = arg.master_position[lane + l] != nullptr;
      if (joints.present[l])
        valid_lane = lane + l;
    }
  if (valid_lane < 0)
    return false;
  for (int l = 0; l < width; ++l)
    {
      const int from            = joints.present[l] ? lane + l : valid_lane;
      joints.master_node[l]     = arg.master_node[from];
      joints.slave_node[l]      = arg.slave_node[from];
      joints.master_position[l] = arg.master_position[from];
      joints.slave_position[l]  = arg.slave_position[from];
      joints.master_velocity[l] = arg.master_velocity[from];
      joints.slave_velocity[l]  = arg.slave_velocity[from];
    }
  return true;
}

/// Three numbers of one node per lane.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void gather_vector(const double *const (&base)[width],
                                            const unsigned int (&offset)[width],
                                            Pack<double, width> (&x)[3])
{
  const double *from[width];
  for (int l = 0; l < width; ++l)
    from[l] = base[l] + offset[l];
  for (int i = 0; i < 3; ++i)
    x[i] = gather(from, i * n_lanes);
}

template <typename P>
CHAINDRIVE_ALWAYS_INLINE P product(const P (&a)[3], const P (&b)[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A vector of the world in the bore's frame.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void into_frame(const P (&axes)[3][3], const P (&x)[3], P (&y)[3])
{
  for (int i = 0; i < 3; ++i)
    y[i] = product(axes[i], x);
}

/// The bore's frame from its nodes: the axis goes through the centres of the first and last rings.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void find_frame(const JointGrid &grid, Joints<width> &joints)
{
  using P                 = Pack<double, width>;
  const unsigned int last = (grid.master_rings - 1) * grid.master_circumferential;
  P                  start[3], end[3], column[3];
  unsigned int       offset[width];
  for (int l = 0; l < width; ++l)
    offset[l] = joints.master_node[l][0];
  gather_vector(joints.master_position, offset, column);
  for (int i = 0; i < 3; ++i)
    start[i] = end[i] = P(0.);
#pragma GCC unroll 1
  for (unsigned int c = 0; c < grid.master_circumferential; c += grid.axis_stride)
    {
      P x[3];
      for (int l = 0; l < width; ++l)
        offset[l] = joints.master_node[l][last + c];
      gather_vector(joints.master_position, offset, x);
      for (int i = 0; i < 3; ++i)
        end[i] += x[i];
      for (int l = 0; l < width; ++l)
        offset[l] = joints.master_node[l][c];
      gather_vector(joints.master_position, offset, x);
      for (int i = 0; i < 3; ++i)
        start[i] += x[i];
    }
  if (grid.half) // the axis of the whole bore is parallel to z
    for (int i = 0; i < 2; ++i)
      start[i] = end[i];
  const P one(1.), share(double(grid.axis_stride) / grid.master_circumferential);
  P(&e)[3][3] = joints.axes;
  for (int i = 0; i < 3; ++i)
    {
      joints.origin[i] = share * start[i];
      e[2][i]          = share * end[i] - joints.origin[i];
      column[i] -= joints.origin[i];
    }
  joints.length   = square_root(product(e[2], e[2]));
  const P inverse = one / joints.length;
  for (int i = 0; i < 3; ++i)
    e[2][i] = e[2][i] * inverse;
  const P along = product(column, e[2]);
  for (int i = 0; i < 3; ++i)
    e[0][i] = column[i] - along * e[2][i];
  const P factor = one / square_root(product(e[0], e[0]));
  for (int i = 0; i < 3; ++i)
    e[0][i] = e[0][i] * factor;
  for (int i = 0; i < 3; ++i)
    e[1][i] = e[2][(i + 1) % 3] * e[0][(i + 2) % 3] - e[2][(i + 2) % 3] * e[0][(i + 1) % 3];
}

/// The slave node whose number in the grid is @p index in each lane.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void
take_slave(const Joints<width> &joints, const unsigned int (&index)[width], Meeting<width> &m)
{
  using P = Pack<double, width>;
  P x[3];
  for (int l = 0; l < width; ++l)
    m.slave[l] = joints.slave_position[l] + joints.slave_node[l][index[l]];
  for (int i = 0; i < 3; ++i)
    x[i] = gather(m.slave, i * n_lanes) - joints.origin[i];
  into_frame(joints.axes, x, m.x);
}

/// How deep inside the bore's ends a slave node is, over half of the length that it stands for:
/// negative outside. @p cover is the reciprocal of that half.
template <int width>
CHAINDRIVE_ALWAYS_INLINE Pack<double, width> depth_inside(const JointGrid      &grid,
                                                          const Joints<width>  &joints,
                                                          const Meeting<width> &m,
                                                          const double          cover)
{
  using P          = Pack<double, width>;
  const P from_end = joints.length - m.x[2];
  return (grid.half ? from_end : least(m.x[2], from_end)) * P(cover);
}

/// How much of the length that a slave node stands for is inside the bore: it falls to 0 at the
/// ends, so that no force begins or ends with a jump.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE P covered(const P depth)
{
  return greatest(P(0.), least(P(1.), depth));
}

/// Where a column passes a plane, but not far beyond its rings: nothing touches there.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE P near_side(const P along)
{
  return greatest(P(-0.01), least(P(1.01), along));
}

/// Places along the columns and corners of the side whose nodes @p m has; see try_side().
template <int width>
CHAINDRIVE_ALWAYS_INLINE void try_nodes(const Joints<width> &joints,
                                        Meeting<width>      &m,
                                        Pack<double, width> &before,
                                        Pack<double, width> &after)
{
  using P = Pack<double, width>;
  P a[4][3];
  for (int q = 0; q < 4; ++q)
    {
      P x[3];
      gather_vector(joints.master_position, m.node[q], x);
      for (int i = 0; i < 3; ++i)
        x[i] -= joints.origin[i];
      into_frame(joints.axes, x, a[q]);
    }
  for (int c = 0; c < 2; ++c)
    {
      for (int i = 0; i < 3; ++i)
        m.rise[c][i] = a[c + 2][i] - a[c][i];
      m.along[c] = (m.x[2] - a[c][2]) / m.rise[c][2];
      const P s  = near_side(m.along[c]);
      for (int i = 0; i < 2; ++i)
        m.corner[c][i] = a[c][i] + s * m.rise[c][i];
    }
  before = m.corner[0][0] * m.x[1] - m.corner[0][1] * m.x[0];
  after  = m.corner[1][1] * m.x[0] - m.corner[1][0] * m.x[1];
}

/// Tries the side of the polygon between the columns @p cell and its next and the rings @p ring
/// [n_lanes apart] and its next: sets nodes, places along and corners. @p before and @p after are
/// positive where the ray lies after the first corner and before the second one, m2.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void try_side(const JointGrid     &grid,
                                       const Joints<width> &joints,
                                       const unsigned int (&cell)[width],
                                       const unsigned int  *ring,
                                       Meeting<width>      &m,
                                       Pack<double, width> &before,
                                       Pack<double, width> &after)
{
  const unsigned int columns = grid.master_circumferential;
  for (int l = 0; l < width; ++l)
    {
      const unsigned int *row  = joints.master_node[l] + ring[l] * columns;
      const unsigned int  next = cell[l] + 1 == columns ? 0 : cell[l] + 1;
      m.node[0][l]             = row[cell[l]];
      m.node[1][l]             = row[next];
      m.node[2][l]             = row[columns + cell[l]];
      m.node[3][l]             = row[columns + next];
    }
  try_nodes(joints, m, before, after);
}

/// Where a ray passes a side that has been tried, and the gap.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void find_gap(const JointGrid          &grid,
                                       const Pack<double, width> before,
                                       const Pack<double, width> after,
                                       Meeting<width>           &m)
{
  using P = Pack<double, width>;
  for (int c = 0; c < 2; ++c)
    m.along[c] = near_side(m.along[c]);

  m.around       = before / (before + after);
  const P toward = (m.corner[0][0] + m.around * (m.corner[1][0] - m.corner[0][0])) * m.x[0] +
                   (m.corner[0][1] + m.around * (m.corner[1][1] - m.corner[0][1])) * m.x[1];
  m.chord = toward / m.radius;
  // the undeformed bore is that far outside the side of its polygon
  const P rest = P(1.) - P(grid.chord_factor) * m.around * (P(1.) - m.around);
  m.gap        = m.chord - m.radius + P(grid.master_radius) * (P(1.) - square_root(rest));
}

/// Below this, times r^2, round-off must not send a search to and fro between two neighbours.
constexpr double side_tolerance = 1e-12;

/// Finds the side of the polygon that the ray passes, from @p cell and @p ring on, which it
/// updates, and with it the gap. A column's neighbours are told by the signs of cross products: no
/// angle is computed, and the bore may be deformed.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void meet(const JointGrid     &grid,
                                   const Joints<width> &joints,
                                   unsigned int (&cell)[width],
                                   unsigned int (&ring)[width],
                                   Meeting<width> &m)
{
  using P                      = Pack<double, width>;
  const unsigned int columns   = grid.master_circumferential;
  const unsigned int last_ring = grid.master_rings - 2;
  constexpr double   tolerance = side_tolerance;

  m.radius       = square_root(m.x[0] * m.x[0] + m.x[1] * m.x[1]);
  const P margin = P(-tolerance) * m.radius * m.radius;
  P       before, after;
  try_side(grid, joints, cell, ring, m, before, after);
#pragma GCC unroll 1
  for (unsigned int trial = 0; trial < columns + last_ring + 2; ++trial)
    {
      const P outside = least(m.along[0], P(1.) - m.along[0]);
      if (!any_less(least(before, after), margin) && !any_less(outside, P(-tolerance)))
        break;
      bool moved = false;
      for (int l = 0; l < width; ++l)
        {
          const unsigned int old_cell = cell[l], old_ring = ring[l];
          if (before[l] < margin[l])
            cell[l] = cell[l] == 0 ? columns - 1 : cell[l] - 1;
          else if (after[l] < margin[l])
            cell[l] = cell[l] + 1 == columns ? 0 : cell[l] + 1;
          if (m.along[0][l] < -tolerance && ring[l] > 0)
            --ring[l];
          else if (m.along[0][l] > 1. + tolerance && ring[l] < last_ring)
            ++ring[l];
          moved |= cell[l] != old_cell || ring[l] != old_ring;
        }
      if (!moved)
        break;
      try_side(grid, joints, cell, ring, m, before, after);
    }
  find_gap(grid, before, after, m);
}

/// The same on the side whose nodes @p m has. Returns false if meet() would go on from there in a
/// lane that @p counts, which is 1 there and 0 in others: to another column, or to another ring,
/// below the first or beyond the second of these places @p along. If @p only, also where it might
/// have ended on another side, from which it would not have come here.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool meet_again(const JointGrid          &grid,
                                         const Joints<width>      &joints,
                                         const Pack<double, width> counts,
                                         const Pack<double, width> (&along)[2],
                                         const bool      only,
                                         Meeting<width> &m)
{
  using P        = Pack<double, width>;
  m.radius       = square_root(m.x[0] * m.x[0] + m.x[1] * m.x[1]);
  const P margin = P(only ? side_tolerance : -side_tolerance) * m.radius * m.radius;
  P       before, after;
  try_nodes(joints, m, before, after);
  const P inside = least(m.along[0] - along[0], along[1] - m.along[0]);
  if (any_less(counts * least(before, after), counts * margin) ||
      any_less(counts * inside, counts * P(only ? 2. * side_tolerance : 0.)))
    return false;
  find_gap(grid, before, after, m);
  return true;
}

/// How a slave node moves against the bore's material: its velocity less that of the point of the
/// polygon which the ray passes, v - sum of weights times nodal velocities. g' is the part against
/// the ray; turns of the bore about its axis (spin) and of its wall (tilt) carry the place of the
/// slave node, which is by the arm r - p farther out, along with it. Components are those in the
/// bore's frame, or those along the ray, round the bore and along it.
template <typename P>
struct Motion
{
  P ray[2];      ///< direction of the ray in the bore's frame
  P relative[3]; ///< velocity against that of the point which the ray passes; ray, round, along;
                 ///< m/s
  P arm;         ///< from that point to the slave node along the ray, m
  // the bore's surface turns
  P side[2]; ///< of the polygon, from the first corner to the second, in the frame, m
  P spin;    ///< of this side about the axis, rad/s
  P rise[2]; ///< from one ring to the other: along the ray, along the axis; m
  P tilt;    ///< of this line, from the axis to the ray, rad/s
};

template <int width>
CHAINDRIVE_ALWAYS_INLINE void find_motion(const Joints<width>         &joints,
                                          const Meeting<width>        &m,
                                          Motion<Pack<double, width>> &motion)
{
  using P = Pack<double, width>;
  P point[3], velocity_around[3], tilting[3]; // world, then frame
  for (int i = 0; i < 3; ++i)
    {
      P upper[2], corner[2];
      for (int c = 0; c < 2; ++c)
        {
          const double *from[width], *to[width];
          for (int l = 0; l < width; ++l)
            {
              from[l] = joints.master_velocity[l] + m.node[c][l];
              to[l]   = joints.master_velocity[l] + m.node[c + 2][l];
            }
          const P lower = gather(from, i * n_lanes);
          upper[c]      = gather(to, i * n_lanes) - lower;
          corner[c]     = lower + m.along[c] * upper[c];
        }
      velocity_around[i] = corner[1] - corner[0];
      tilting[i]         = upper[0] + m.around * (upper[1] - upper[0]);

      const double *from[width];
      for (int l = 0; l < width; ++l)
        from[l] = joints.slave_velocity[l] + (m.slave[l] - joints.slave_position[l]);
      point[i] = gather(from, i * n_lanes) - corner[0] - m.around * velocity_around[i];
    }
  const P one(1.), inverse = one / m.radius;
  P(&ray)[2] = motion.ray;
  P v[3], turn[3], lean[3];
  into_frame(joints.axes, point, v);
  into_frame(joints.axes, velocity_around, turn);
  into_frame(joints.axes, tilting, lean);
  for (int i = 0; i < 2; ++i)
    {
      ray[i]         = m.x[i] * inverse;
      motion.side[i] = m.corner[1][i] - m.corner[0][i];
    }
  motion.relative[0] = v[0] * ray[0] + v[1] * ray[1];
  motion.relative[1] = v[1] * ray[0] - v[0] * ray[1];
  motion.relative[2] = v[2];
  motion.arm         = m.radius - m.chord;

  motion.spin = (motion.side[0] * turn[1] - motion.side[1] * turn[0]) /
                (motion.side[0] * motion.side[0] + motion.side[1] * motion.side[1]);
  P rise[3];
  for (int i = 0; i < 3; ++i)
    rise[i] = m.rise[0][i] + m.around * (m.rise[1][i] - m.rise[0][i]);
  motion.rise[0] = rise[0] * ray[0] + rise[1] * ray[1];
  motion.rise[1] = rise[2];
  motion.tilt =
      (motion.rise[0] * lean[2] - motion.rise[1] * (lean[0] * ray[0] + lean[1] * ray[1])) /
      (motion.rise[0] * motion.rise[0] + motion.rise[1] * motion.rise[1]);
}
} // namespace chaindrive::contact::packed
