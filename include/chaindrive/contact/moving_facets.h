// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/node_view.h>
#include <chaindrive/mesh/nodes.h>
#include <chaindrive/mesh/part.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace chaindrive::contact
{
/// Vectors of some nodes of one body: positions or velocities.
struct NodeValues
{
  NodeView<const double>          field; ///< all of this rank's
  const std::vector<std::size_t> &index; ///< per node, in the field

  dealii::Tensor<1, 3> operator()(const unsigned int i) const { return field[index[i]]; }
};

/// The facets of a nearly flat side of an elastic part: bilinear through its nodes, wherever these
/// are.
class MovingFacets
{
public:
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  /// The faces of @p part that carry @p surface and whose centre @p chosen accepts. @p nodes are
  /// those of the part.
  MovingFacets(const mesh::Part                                    &part,
               const mesh::Nodes                                   &nodes,
               mesh::Surface                                        surface,
               const std::function<bool(const dealii::Point<3> &)> &chosen);

  /// Nodes of the part that the facets have, each once. Below, nodes are numbered in this order.
  const std::vector<unsigned int> &nodes() const { return nodes_; }
  unsigned int                     n_facets() const { return unsigned(quads_.size()); }

  /// The point of the facets below a given one.
  struct Projection
  {
    unsigned int                        facet = none; ///< none: the point is not above any
    std::array<unsigned int, 4>         node{};
    std::array<double, 4>               weight{};
    std::array<dealii::Tensor<1, 3>, 4> gradient; ///< of the weights along the facet, 1/m
    dealii::Tensor<1, 3>                normal;   ///< unit, outward
    double                              gap = 0.; ///< along the normal, m
  };

  /// The projection of @p x on the facets whose nodes are at @p position. It is looked for from
  /// facet @p start on, across the facets' edges; from each of them with none. Beyond the rim a
  /// facet goes on for a tenth of its size.
  Projection
  project(const NodeValues &position, const dealii::Tensor<1, 3> &x, unsigned int start) const;

  const std::vector<double> &areas() const { return area_; } ///< a quarter of each facet, m2

  /// Per node the least and the greatest of @p values, one per node, in the facets about it.
  std::vector<std::array<double, 2>> ranges(const std::vector<double> &values) const;

private:
  /// The projection of @p x on @p facet or its continuation, and the edge that it lies beyond most,
  /// or 4.
  unsigned int project_on(const NodeValues           &position,
                          const dealii::Tensor<1, 3> &x,
                          unsigned int                facet,
                          double                      margin,
                          Projection                 &projection) const;

  std::vector<unsigned int>                nodes_;
  std::vector<double>                      area_;
  std::vector<std::array<unsigned int, 4>> quads_;  ///< counter-clockwise seen from outside
  std::vector<std::array<unsigned int, 4>> beyond_; ///< facet across edge e, from corner e to e + 1
};
} // namespace chaindrive::contact
