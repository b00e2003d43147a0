// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

namespace chaindrive
{
/// How a batch of bodies stands and moves as rigid ones, [lane]: rotation matrix row by row,
/// position and velocity of the centre of mass, angular velocity, in world axes.
enum RigidEntry : unsigned int
{
  rigid_rotation         = 0,
  rigid_position         = 9,  ///< m
  rigid_velocity         = 12, ///< m/s
  rigid_angular_velocity = 15, ///< rad/s
  n_rigid_entries        = 18
};

/// Some nodes of a batch of reduced bodies and the modes that move them, by a Symmetry of the part
/// (reduction/symmetry.h): an orbit is a node and its images, and the table of modes has the
/// motion of the first of them alone. All arrays are aligned to 64 bytes.
struct ModalNodes
{
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  unsigned int        n_orbits;      ///< some
  const unsigned int *orbit;         ///< their numbers in the table of modes
  unsigned int        n_images;      ///< as many as classes: 1, 2, 4 or 8
  const unsigned int *node;          ///< [orbit][image], numbers in the part; none: not wanted
  unsigned int        reflection[3]; ///< Symmetry::reflection(), [component]
  unsigned int        n_modes;
  const unsigned int *first_mode; ///< [class], and n_modes: modes are in the order of classes
  const double       *reference;  ///< [node of the part][component], body axes, m
  const double       *mode_shape; ///< [orbit][mode][component], body axes, 1/sqrt(kg)
  const double       *rigid;      ///< [RigidEntry][lane]
};

/// Where these nodes are and how fast they move:
///
///   x = x_c + R (X + Phi q),   v = v_c + s + w x (a - e (w x a + 2 s)),
///
/// with the arm a = x - x_c and the speed s = R Phi q' beside the rigid motion. Velocities belong
/// to the instant e before the positions, and are the secants of what moves between (see
/// World::velocity_at()). After a step of dt = 2 e in which q' was the mean they are, for half of
/// the work, v = (x - x_before) / dt, with the positions that these nodes had before it.
struct PlaceArguments
{
  ModalNodes    nodes;
  const double *amplitude; ///< q, [mode][lane], m sqrt(kg)
  const double *rate;      ///< q', [mode][lane]; null: the step tells
  double        earlier;   ///< e, s
  double       *position;  ///< [node of the part][component][lane], world axes, m
  double       *velocity;  ///< m/s
};

/// What forces on these nodes are to the body: its generalised forces Q = sum Phi^T R^T f, their
/// couple about its centre of mass, and other sums over nodes of this kind. The forces become zero.
struct GatherArguments
{
  ModalNodes    nodes;
  const double *position;    ///< [node of the part][component][lane], world axes, m
  double       *force;       ///< N
  char         *pressed;     ///< [node of the part], 0 where there is no force, which all become
  double       *modal_force; ///< Q, [mode][lane], which is set, N/sqrt(kg)
  double       *moment;      ///< [component][lane], which is set, N m
  unsigned int  n_measures;
  const double *measure;  ///< [orbit][class][measure][component], as a mode of that class alone
  double       *measured; ///< [measure][lane], which is set
  double       *in_body;  ///< room for three numbers per orbit, image and lane
  unsigned int *found;    ///< room for one number per orbit
};

/// The kernels of one instruction set.
struct ModalKernels
{
  int width; ///< numbers that the machine computes at a time
  void (*place)(const PlaceArguments &);
  void (*gather)(const GatherArguments &);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none, as with
/// element::kernels().
const ModalKernels *modal_kernels(int width);
} // namespace chaindrive
