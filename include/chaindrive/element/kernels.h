// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

#include <chaindrive/utilities/pack.h>

namespace chaindrive::element
{
/// How a trilinear hexahedron is integrated.
enum class Formulation
{
  one_point, ///< mean gradient, hourglass stiffness after Flanagan and Belytschko (1981)
  enhanced,  ///< mean gradient, hourglass stiffness condensed from incompatible modes ("EAS1")
  full       ///< 2 x 2 x 2 points of Gauss' rule
};

/// What all copies of one element share. Vertices are in deal.II's order; with the coordinates
/// s_d = -1 or 1 of a vertex its four hourglass vectors are h = s_x s_y, s_y s_z, s_z s_x, s_x s_y
/// s_z.
struct Hexahedron
{
  unsigned int node[8];
  double       volume;         ///< V, m3
  double       gradient[3][8]; ///< B: mean of dN_a / dX_j over the volume, 1/m
  double       shift[4][3]; ///< h_alpha . X_j: the part of the hourglass vectors that is linear, m
};

/// Stiffness of the hourglass amplitudes q_alpha,k = gamma_alpha . u_k, with
/// gamma_alpha = h_alpha - B_j (h_alpha . X_j); row and column 3 alpha + k; N/m.
struct HourglassStiffness
{
  double k[12][12];
};

/// Gradients [1/m] and volumes [m3] at the points of Gauss' rule.
struct PointGradients
{
  double gradient[8][3][8]; ///< point, direction, vertex
  double volume[8];
};

/// One batch: n_lanes copies of a part, side by side in memory as [node][component][lane].
/// Positions instead of displacements: wherever a copy was placed and turned at the start, their
/// gradients are its deformation gradient times that turn, which Green's strain does not see.
struct ForceArguments
{
  unsigned int              n_elements;
  const Hexahedron         *elements;
  const HourglassStiffness *hourglass;           ///< formulation enhanced
  const double             *hourglass_stiffness; ///< formulation one_point: of every amplitude, N/m
  const PointGradients     *points;              ///< formulation full
  double                    lambda, mu;          ///< Lamé's constants, Pa
  const double             *position;            ///< world axes, m
  double                   *force;               ///< to which the internal forces are added, N
  double                   *strain_energy;       ///< [lane], to which is added, J
  double                   *hourglass_energy;    ///< [lane], to which is added, J
};

/// One step of a batch: v += kick (f / m + g - drag v), then x += drift v. Forces are set to zero.
/// What is summed belongs to the instant of the forces: positions before, velocities in the middle
/// of the kick.
struct UpdateArguments
{
  unsigned int  n_nodes;
  double        kick, drift;    ///< s
  double        gravity[3];     ///< g, m/s2
  double        drag;           ///< 1/s
  const double *mass;           ///< per node, kg
  double       *position;       ///< m
  double       *velocity;       ///< half a step behind the position, m/s
  double       *force;          ///< N
  double       *kinetic_energy; ///< [lane], to which is added, J
  double       *first_moment;   ///< [component][lane], to which sum m x is added, kg m
  double       *momentum;       ///< [component][lane], to which sum m v is added, kg m/s
};

/// The kernels of one instruction set.
struct Kernels
{
  const char *name;  ///< of the instruction set
  int         width; ///< numbers that the machine computes at a time
  void (*add_internal_forces[3])(const ForceArguments &); ///< by Formulation
  void (*update)(const UpdateArguments &);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none.
const Kernels *kernels(int width);

/// The widest kernels that this machine has, or those of the width that the environment variable
/// CHAINDRIVE_SIMD_WIDTH asks for. Throws InputError if it has none of that width.
const Kernels &best_kernels();
} // namespace chaindrive::element
