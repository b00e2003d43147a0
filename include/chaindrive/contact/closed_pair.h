// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <vector>

namespace chaindrive::contact
{
/// A spring between a node of a cylinder and the point of the bore that it meets.
struct ClosedSpring
{
  unsigned int                node = 0;      ///< of the cylinder's body
  std::array<unsigned int, 4> bore_nodes{};  ///< that carry the point
  std::array<double, 4>       weights{};     ///< of their displacements in that of the point
  double                      stiffness = 0; ///< N/m
  dealii::Tensor<1, 3>        normal;        ///< unit, in axes of the cylinder's body
};

/// What the contact of elastic nodes, all of it held closed, is to one of its two sides: springs
/// between each node and a ground, if the other side stood still.
struct ClosedSide
{
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  unsigned int        group   = none;  ///< of the bodies in World::copies; none: without nodes
  unsigned int        surface = none;  ///< of their mesh: a node of it is in one contact at a time
  std::vector<double> stiffness;       ///< per node of an elastic body, N/m; empty: a rigid one
  double              eigenvalue = 0.; ///< largest of the springs and the masses alone, 1/s2

  /// Per node with a spring, unit, in body axes: the direction of the springs, to which friction
  /// acts across. Empty: springs hold nodes in all directions alike.
  std::vector<dealii::Tensor<1, 3>> normal;

  /// Of a cylinder with elastic nodes in a bore with such: the springs between the two.
  std::vector<ClosedSpring> springs;

  /// Of a round side: up to which angle [rad] from the middle of a contact it may touch. At least
  /// a straight angle: all of it may touch at a time.
  double half_angle = dealii::numbers::PI;

  /// It is flat, across z: faces at z > 0 and z < 0, of which each place touches at one at a time.
  bool flat = false;

  bool touches_in_part() const { return half_angle < dealii::numbers::PI; }

  /// Holds an elastic body's node of @p mass [kg] by a spring @p k [N/m].
  void add_spring(const unsigned int node, const double k, const double mass)
  {
    stiffness[node] = k;
    eigenvalue      = std::max(eigenvalue, k / mass);
  }
};

/// The two sides of all pairs of one kind: master and slave.
using ClosedPair = std::array<ClosedSide, 2>;
} // namespace chaindrive::contact
