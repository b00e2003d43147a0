// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/free_part.h>

#include <functional>
#include <string>
#include <vector>

namespace chaindrive::reduction
{
/// The highest harmonics about the axis of the pressures in which a part deflects.
struct Orders
{
  unsigned int tube = 8; ///< of rollers and bushes, which become oval
  unsigned int pin  = 6;

  /// Sides in joints too: else what they deflect beside natural modes has no inertia, see
  /// round_flexibility.h, and no pressures on them are needed.
  bool in_joints = true;

  /// The outside of rollers too, on which teeth press. Not without in_joints being false as well.
  bool on_teeth = true;

  /// Flat faces of plates too, which touch where wheels are out of line.
  bool on_faces = false;
};

/// The cylindrical sides of @p part that touch others but for the outside of rollers, in which
/// teeth press.
std::vector<mesh::Surface> joint_sides(const mesh::Part &part);

/// What acts on every cylindrical side of @p part that touches another part, as forces of the
/// nodes, N, with zeta = z over half of the side's length:
/// - pressures [Pa] cos(n theta), sin(n theta) times powers of zeta, n up to the @p orders as long
///   as there are more than two columns of nodes for a wave. The powers go up to 2, on bores of
///   bushes to 4 and on pins, which bend in them, to 6, without odd ones on a half part;
/// - on plates of links, if they are asked for, even pressures on a face of each plate: about
///   either joint, and on the inner faces of inner plates in the middle on either side of the line
///   between the joints, where teeth are;
/// - on links, even friction around the side: its couple bends them, which no pressure does. On
///   whole parts also zeta times as much, friction that differs from one end to the other.
std::vector<Vector>
tractions(const mesh::Part &part, const mesh::Nodes &nodes, const Orders &orders);

/// A load by which the statics of a basis are judged.
struct Load
{
  std::string name;
  Vector      force; ///< N
};

/// Loads as contacts make them, pressures of 1 Pa at their peak, on every cylindrical side that
/// touches:
/// - pull: cos theta on the half that is pressed, on both joints of a link apart;
/// - pull at the ends: the same on the outer halves of the length alone;
/// - side: cos theta on the half towards the chain's side, on one joint;
/// - patch: even pressure within 22.5 degrees, along the chain and across it;
/// - turn: even friction around the side, on one joint of a link.
std::vector<Load> contact_loads(const mesh::Part &part, const mesh::Nodes &nodes);
} // namespace chaindrive::reduction
