// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/nodes.h>

#include <vector>

namespace chaindrive::reduction
{
/// Reflections in planes through the centre of a part, across its axes, that leave it what it is.
/// Any two commute, so that motions of the part can be told apart by what each reflection makes of
/// them: the same motion, or its opposite. The classes are numbered by bits, bit r being set for
/// motions that are odd in the reflection r; so are the images of a node, bit r being set where it
/// was reflected. A motion of the class c that moves a node by u moves its image g by
///
///   (-1)^|c and g| S_g u,
///
/// S_g having the opposite sign in the components that were reflected and |.| the number of bits.
struct Symmetry
{
  std::vector<unsigned int>              axis;   ///< of each reflection: 0, 1 or 2
  std::vector<std::vector<unsigned int>> mirror; ///< [reflection][node]: its mirror image

  /// As many as there are images of a node: 1, 2, 4 or 8.
  unsigned int n_classes() const { return 1u << axis.size(); }

  /// The image @p g of @p node.
  unsigned int image(unsigned int node, unsigned int g) const;

  /// The reflection that changes the sign of component @p d, as the bit of it; 0 if none does. The
  /// signs above are those of (-1)^|g and (c xor this)|.
  unsigned int reflection(unsigned int d) const;

  /// The sign above of component @p d.
  double sign(const unsigned int g, const unsigned int c, const unsigned int d) const
  {
    const unsigned int bits = g & (c ^ reflection(d));
    return ((bits ^ (bits >> 1) ^ (bits >> 2)) & 1u) != 0 ? -1. : 1.;
  }
};

/// The node at the mirror image of each of the @p nodes in the plane through the origin across
/// @p axis, within 1e-6 of the part's size; empty if there is none for some.
std::vector<unsigned int> mirror_images(const mesh::Nodes &nodes, unsigned int axis);

/// The symmetry of some @p nodes in the planes across the axes @p axis, which they must have.
Symmetry make_symmetry(const mesh::Nodes &nodes, const std::vector<unsigned int> &axis);
} // namespace chaindrive::reduction
