// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

#include <chaindrive/element/shapes.h>
#include <chaindrive/parameters/formulation.h>

namespace chaindrive::element
{
/// How the elements of a block are integrated: those of section Elements, and solid-shells, which
/// are as enhanced but condensed from a solid-shell (solid_shell_stiffness.h).
enum class Formulation
{
  one_point = static_cast<int>(parameters::Formulation::one_point),
  enhanced  = static_cast<int>(parameters::Formulation::enhanced),
  full      = static_cast<int>(parameters::Formulation::full),
  solid_shell
};

/// The vertices of an element in deal.II's order, and where its numbers begin: elements of one
/// geometry share them.
struct Vertices
{
  unsigned int node[8];
  unsigned int numbers;
};

/// What the kernels read of an element besides its vertices, one number after the other:
/// - with one point: the volume V [m3]; the mean gradient G [1/m] in terms of the base vectors (see
///   shapes.h), row by row; the linear part h_alpha . X_j [m] of the hourglass vectors, row by row;
///   then the stiffness [N/m] of the hourglass amplitudes q_alpha,k = gamma_alpha . u_k with
///   gamma_alpha = h_alpha - B_j (h_alpha . X_j): one number for all (Formulation::one_point), or
///   the lower triangle of each block of the matrix, row by row (Formulation::enhanced and
///   solid-shell);
/// - of a solid-shell also twice the mean Green's strain per amplitude, row by row, 1/m;
/// - with eight: at each of them the volume and the inverse of the Jacobian dX / dxi, row by row.
/// Only those that do not vanish for the shape.
constexpr int n_numbers(const Shape shape, const Formulation formulation)
{
  if (formulation == Formulation::full)
    return (shape == Shape::general ? 8 : 4) * (1 + jacobian_entries(shape).size);
  return 1 + gradient_entries(shape).size + shift_entries(shape).size +
         (formulation == Formulation::one_point ? 1 : hourglass_entries(shape).size) +
         (formulation == Formulation::solid_shell ? coupling_entries(shape).size : 0);
}

/// One batch: n_lanes copies of a part, side by side in memory as [node][component][lane].
/// Positions instead of displacements: wherever a copy was placed and turned at the start, their
/// gradients are its deformation gradient times that turn, which Green's strain does not see.
struct ForceArguments
{
  unsigned int    n_elements;
  Shape           shape;            ///< of all elements
  const Vertices *vertices;         ///< per element
  const double   *numbers;          ///< n_numbers() per geometry
  double          lambda, mu;       ///< Lamé's constants, Pa
  const double   *position;         ///< world axes, m
  double         *force;            ///< to which the internal forces are added, N
  double         *strain_energy;    ///< [lane], to which is added, J
  double         *hourglass_energy; ///< [lane], to which is added, J
  const double   *next;   ///< what is read afterwards, and fetched into the cache meanwhile
  unsigned int    n_next; ///< numbers there
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

/// What accelerates the nodes of columns together (SelectiveMasses), of one batch. With M' = L D
/// L^T, L having ones on its diagonal, the accelerations a = M'^-1 f are found and forces become M
/// a. To the kinetic energy is added what M' has more than M at the instant of the forces, with the
/// velocities in the middle of the kick.
struct SelectiveMassArguments
{
  unsigned int        n_columns;
  const unsigned int *begin; ///< per column and for the end: where it begins in what follows
  const unsigned int *node;
  const double       *mass;           ///< M, per node of the part, kg
  const double       *added;          ///< mass between a node and the next of its column, kg
  const double       *lower;          ///< L: in the row of the node, left of the diagonal; 1
  const double       *pivot;          ///< 1 / D, 1/kg
  double              kick;           ///< s
  double              drag;           ///< 1/s
  const double       *velocity;       ///< half a step before the instant, m/s
  double             *force;          ///< N
  double             *kinetic_energy; ///< [lane], to which is added, J
};

/// The kernels of one instruction set.
struct Kernels
{
  const char *name;  ///< of the instruction set
  int         width; ///< numbers that the machine computes at a time
  void (*add_internal_forces[4])(const ForceArguments &); ///< by Formulation
  void (*update)(const UpdateArguments &);
  void (*apply_selective_masses)(const SelectiveMassArguments &);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none.
const Kernels *kernels(int width);

/// The kernels of the width of simd_width().
const Kernels &best_kernels();
} // namespace chaindrive::element
