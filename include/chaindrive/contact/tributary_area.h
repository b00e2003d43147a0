// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/surface/cylinder_grid.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
/// How wide the shares of a node in its side are along one direction and across it, m: the half
/// widths of its shape function.
struct TributaryArea
{
  TributaryArea() = default;

  /// Of a node at @p at [m] along the direction, whose facets reach from @p low to @p high and of
  /// which the area @p area [m2] belongs to it: all of the one facet's extent where the side ends.
  TributaryArea(const double area, const double at, const double low, const double high)
  {
    const double half = 0.5 * (high - low);
    const bool   end  = at - low < 0.01 * half || high - at < 0.01 * half;
    along             = end ? 2. * half : half;
    across            = area / half;
  }

  void grow_to(const TributaryArea &other)
  {
    along  = std::max(along, other.along);
    across = std::max(across, other.across);
  }

  double along = 0., across = 0.;
};

/// The area [m2] of slaves that a node carries by its shape function, at most; @p slave is the
/// largest share of any of them. The sum of a hat of half width L at points of spacing a is at most
/// 9/8 max(L, a) / a.
inline double carried_area(const TributaryArea &node, const TributaryArea &slave)
{
  return 81. / 64. * std::max(node.along, slave.along) * std::max(node.across, slave.across);
}

/// The length [m] that a hat of half width @p l carries of equidistant points @p a apart [m], each
/// of which stands for the length a, at most: when it stands over one of them. It is l where l is a
/// multiple of a, and never less than either.
inline double carried_length(const double l, const double a)
{
  const double q = std::floor(l / a * (1. + 1e-12));
  return a * (1. + 2. * q - q * (q + 1.) * a / l);
}

/// The area [m2] of the slave's nodes that a node of a bore in @p ring carries, at most,
/// wherever along and about the axis the @p slave is. In symmetry models it stays where it is.
double
carried_area(const mesh::CylinderGrid &bore, unsigned int ring, const mesh::CylinderGrid &slave);
} // namespace chaindrive::contact
