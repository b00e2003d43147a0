// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>
#include <chaindrive/mesh/surface/coons_patch.h>

#include <deal.II/numerics/rtree.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace chaindrive::mesh
{
/// The point of a facet surface that is nearest to a given point.
struct Projection
{
  static constexpr unsigned int no_facet = std::numeric_limits<unsigned int>::max();

  bool                  found    = false;
  double                distance = std::numeric_limits<double>::max(); ///< m, negative inside
  dealii::Point<3>      point;                                         ///< on the smooth surface, m
  dealii::Tensor<1, 3>  normal;                                        ///< unit, outward
  unsigned int          facet = no_facet; ///< index of the facet that holds the point
  std::array<double, 4> weights{};        ///< bilinear shape functions of the facet's vertices
};

/// A smooth master surface over the boundary quadrilaterals of a mesh.
///
/// Between sharp edges the facets are replaced by Coons patches over cubic edges, whose end
/// tangents are those of circles through neighbouring vertices. Positions and a normal field are
/// interpolated alike and are continuous across facets; the nearest point x of p is the one with p
/// = x + d n(x). A circular arc is reproduced to sixth order in the angle that a facet spans, also
/// where it meets another arc at a vertex with a common tangent. Across edges sharper than the
/// crease angle nothing is smoothed: a convex one is met as an edge, with the normal pointing from
/// it.
class FacetSurface
{
public:
  /// The boundary faces of @p part that carry @p surface, in the body frame. Throws InputError if
  /// there are none. @p crease_angle in rad.
  FacetSurface(const Part &part, Surface surface, double crease_angle = 0.7);

  /// From vertices [m] and quadrilaterals, numbered counter-clockwise seen from outside. Throws
  /// InputError where more than two of them share an edge.
  FacetSurface(const std::vector<dealii::Point<3>>            &vertices,
               const std::vector<std::array<unsigned int, 4>> &quads,
               double                                          crease_angle = 0.7);

  /// The nearest point of the surface within @p search_radius [m] of @p p. A point that looks past
  /// the rim of an open surface has none. @p hint, the facet of an earlier projection of a point
  /// near by, saves time and does not change the result.
  Projection closest_point(const dealii::Point<3> &p,
                           double                  search_radius,
                           unsigned int            hint = Projection::no_facet) const;

  /// Gradients [1/m] of the weights of @p at, a projection onto this surface, while the point moves
  /// along the surface; on a sharp edge, along that.
  std::array<dealii::Tensor<1, 3>, 4> gradients(const Projection &at) const;

  unsigned int n_facets() const { return static_cast<unsigned int>(patches_.size()); }

  /// The four vertices of @p facet, in the order of Projection::weights, by their numbers in the
  /// mesh that the surface was made from.
  const std::array<unsigned int, 4> &vertices(unsigned int facet) const { return quads_[facet]; }

private:
  std::vector<std::array<unsigned int, 4>>                       quads_;
  std::vector<CoonsPatch>                                        patches_;
  dealii::RTree<std::pair<dealii::BoundingBox<3>, unsigned int>> tree_;
};
} // namespace chaindrive::mesh
