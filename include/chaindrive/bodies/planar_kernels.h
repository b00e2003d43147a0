// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

namespace chaindrive
{
/// What is known of a body that stays in the plane, [PlanarEntry][slot]. What contacts read and add
/// to stands in rows that Rows finds for nothing.
enum PlanarEntry : unsigned int
{
  planar_position         = 0,  ///< of the centre of mass, x and y, m
  planar_spin             = 2,  ///< angular velocity, rad/s
  planar_inverse_mass     = 3,  ///< 1/kg
  planar_velocity         = 4,  ///< x and y, m/s
  planar_rotation         = 6,  ///< cosine and sine of the body's angle
  planar_force            = 8,  ///< resultant, x and y, N
  planar_origin           = 10, ///< where its centre of mass was at the start, x and y, m
  planar_inverse_inertia  = 12, ///< 1/(kg m2); 0: does not turn
  planar_moment           = 13, ///< about the centre of mass, N m
  planar_displacement     = 14, ///< position less origin, which it is the sum of, x and y, m
  planar_mass             = 16, ///< kg
  planar_inertia          = 17, ///< kg m2
  planar_follows_rotation = 18, ///< 1: it has an angle; 0: a ring, which looks the same at any
  n_planar_entries        = 19,

  // where rollers become ovals (drive::RollerRing); those of other bodies are zero
  planar_ring = 19, ///< a and b: the outside moves outwards by a cos 2 angle + b sin 2
                    ///< angle, of angles in the world, m
  planar_ring_rate          = 21, ///< m/s
  planar_ring_force         = 23, ///< on a and b, N
  planar_ring_inverse_mass  = 25, ///< 1/kg
  planar_ring_mass          = 26, ///< kg
  planar_ring_stiffness     = 27, ///< N/m
  n_planar_entries_of_ovals = 28
};

/// Bodies in slots; their number is a multiple of n_lanes, and the array aligned to 64 bytes. Slots
/// without a body are zero.
struct PlanarSlots
{
  double      *state; ///< [PlanarEntry][slot]
  unsigned int n_slots;

  double       *of(const unsigned int entry) { return state + entry * n_slots; }
  const double *of(const unsigned int entry) const { return state + entry * n_slots; }
};

/// Loads on all bodies, and what they come to.
struct PlanarLoads
{
  double gravity;   ///< along -y, m/s2
  double drag;      ///< 1/s
  double potential; ///< is set: of gravity, J
  double power;     ///< is set: that drag takes, W
};

/// A run of massless bars: bar i is between the bodies in the slots first + i and second + i.
/// Arrays hold a multiple of n_lanes, of which those beyond the last bar have no stiffness and no
/// damping.
struct PlanarBars
{
  unsigned int  first, second, n;
  const double *unloaded, *stiffness, *damping; ///< m, N/m, N s/m
  double       *tension;                        ///< is set, N
  double       *length, *viscous;               ///< at the last evaluation, and are set: m, N
  double        energy, loss;                   ///< are added to, J
};

/// The kernels of one instruction set. Newmark's method as in RigidBodies.
struct PlanarKernels
{
  int width; ///< numbers that the machine computes at a time
  /// Adds @p h [s] times the accelerations to the velocities; returns the kinetic energy, J.
  double (*kick)(PlanarSlots, double h);
  /// The same, and moves by a step @p dt [s]. Forces become those of the loads where bodies are
  /// then. Returns the largest square of a speed, m2/s2.
  double (*advance)(PlanarSlots, double h, double dt, PlanarLoads &);
  /// Adds the forces of the loads.
  void (*load)(PlanarSlots, PlanarLoads &);
  double (*kinetic_energy)(PlanarSlots); ///< J
  void (*stretch)(PlanarSlots, PlanarBars &);
  /// The same three of ovals, and their elastic forces, which are added; returns their energy, J.
  void (*kick_ovals)(PlanarSlots, double h);
  void (*drift_ovals)(PlanarSlots, double dt);
  double (*kinetic_energy_of_ovals)(PlanarSlots);
  double (*bend_ovals)(PlanarSlots);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none, as with
/// element::kernels().
const PlanarKernels *planar_kernels(int width);
} // namespace chaindrive
