// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

#include <chaindrive/scene/contact_law.h>
#include <chaindrive/utilities/pack.h>

#include <cstddef>

namespace chaindrive::contact
{
/// What the two sides of all joints of one kind have in common. The bore is the master, the
/// cylinder inside it the slave; the columns of both run round the same way, their rings the
/// same way along the axes.
struct JointGrid
{
  unsigned int  master_circumferential, master_rings;
  unsigned int  axis_stride; ///< the bore's axis is that of every so-many-th master column
  unsigned int  slave_circumferential, slave_rings;
  unsigned int  first_ring, end_ring; ///< of the slave's, those that a search looks at
  double        master_radius;        ///< undeformed, m
  double        chord_factor;         ///< 4 sin^2(pi / master_circumferential)
  bool          half; ///< the bore goes on beyond its first ring, see mesh::Part::half
  const double *area; ///< per slave ring, of each node there, m2
  const double
      *inside; ///< the same of the part that is inside a bore that is not displaced along it
  const double *cover; ///< 1/m; per slave ring, one over half of the length it stands for
};

/// What a slave node remembers from step to step: contact::TouchState in numbers. Its penetration
/// is the mean of that of the surface about it. The tangents are those round the bore,
/// counter-clockwise, and along it.
enum TouchEntry : unsigned int
{
  touch_penetration,       ///< m
  touch_normal,            ///< N
  touch_slip_around,       ///< m
  touch_slip_along,        ///< m
  touch_tangential_around, ///< N
  touch_tangential_along,  ///< N
  n_touch_entries
};

/// The slave columns that a lane visits: @p count of them from @p first on, round and round.
struct JointWindow
{
  unsigned int first[n_lanes];
  unsigned int count[n_lanes]; ///< all columns: no beginning and no end; 0: none
  unsigned int
      cell[n_lanes]; ///< master column where the search begins at the first of them; kept fresh
};

/// What the force kernel finds, per lane.
struct JointSums
{
  // of the last call
  double       stored[n_lanes];   ///< energy of the penalty springs, normal and tangential, J
  double       force[3][n_lanes]; ///< resultant on the slave, world axes, N
  double       largest_penetration[n_lanes]; ///< largest penetration, m
  unsigned int touching[n_lanes];            ///< nodes with a force
  // added up until the caller clears them
  double damping_loss[n_lanes];  ///< J
  double friction_loss[n_lanes]; ///< J
};

/// Up to n_lanes joints of one kind. Each lane has its own two bodies: base pointers lead to the
/// body's lane inside its batch, so that the number at base[offset + i n_lanes] is component i of
/// the node with that offset, 3 n_lanes times its number. A lane without a joint has null pointers.
struct JointArguments
{
  const JointGrid    *grid;
  const unsigned int *master_node[n_lanes]; ///< offsets [ring][column]
  const unsigned int *slave_node[n_lanes];
  const double       *master_position[n_lanes]; ///< world axes, m
  const double       *slave_position[n_lanes];
  const double       *master_velocity[n_lanes]; ///< half a step behind the positions, m/s
  const double       *slave_velocity[n_lanes];
  double             *master_force[n_lanes]; ///< to which contact forces are added, N
  double             *slave_force[n_lanes];
  char               *master_pressed[n_lanes]; ///< [node] of the body, 1 where there is a force;
  char               *slave_pressed[n_lanes];  ///< null: nobody wants to know
  scene::ContactLaw   law;                     ///< per m2
  double              dt;                      ///< since the last call, s; 0 at the first one
  double             *state; ///< [slave node][TouchEntry][lane], zero at the start
  unsigned int       *ring;  ///< [slave ring][lane], master ring that it met last
  unsigned int       *cell;  ///< [slave column][lane], master column that it met last
  JointWindow        *window;
  JointSums          *sums;
};

/// The gaps of slave nodes, for the search. Arrays of numbers are aligned to 64 bytes.
struct GapArguments
{
  const char *wanted; ///< [slave column][lane]: columns where it is 0 for all lanes are let alone
  bool        wants_closing;
  double     *gap;         ///< [slave node][lane], m; beyond the bore's ends, that to its end
  double     *covered;     ///< [slave node][lane], from 0 beyond the bore's ends to 1 inside
  double closing[n_lanes]; ///< greatest rate at which a gap becomes smaller, m/s; 0 if none does,
                           ///< or unless wants_closing
};

/// Nodes of joints whose normal forces are found for all nodes of a joint together, without a
/// penalty. Each lane visits nodes of its window in an order of its own. Arrays of numbers are
/// [visit][lane], aligned to 64 bytes.
struct WindowNodes
{
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  unsigned int        n_rings;
  const unsigned int *ring;     ///< slave rings
  unsigned int        n_visits; ///< there may be more in the order
  const unsigned int *order;    ///< nodes: place of the column in the window times n_rings plus the
                                ///< number among the rings; none where a lane has no more
  double       *gap;            ///< m; a metre where there is none
  const double *force;          ///< normal forces, N
  char         *known; ///< which nodes these are in the bodies, JointKernels::known_room():
                       ///< zeros where the window is new, otherwise what was left there
  char *met;           ///< room for what measure_window() finds and press() reads again, see
                       ///< JointKernels::room(); bodies must not move in between

  unsigned int        n_pressed;
  const unsigned int *pressed; ///< visits of nodes that have a force in any lane or had one before
};

/// The kernels of one instruction set.
struct JointKernels
{
  int width; ///< numbers that the machine computes at a time
  /// Contact forces on both sides of each lane, for the slave nodes of its window.
  void (*add_forces)(const JointArguments &);
  /// Geometry alone, for slave nodes of each lane, whatever the window.
  void (*measure)(const JointArguments &, GapArguments &);
  /// Gaps of the slave nodes that each lane visits.
  void (*measure_window)(const JointArguments &, const WindowNodes &);
  /// Bytes of WindowNodes::met and of WindowNodes::known for so many visits.
  std::size_t (*room)(std::size_t n_visits);
  std::size_t (*known_room)(std::size_t n_visits);
  /// After measure_window(), adds the normal forces to both sides of each lane, with friction. What
  /// a node remembers as its penetration is its normal force.
  void (*press)(const JointArguments &, const WindowNodes &);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none, as with
/// element::kernels().
const JointKernels *joint_kernels(int width);
} // namespace chaindrive::contact
