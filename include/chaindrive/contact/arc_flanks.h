// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/elastic_flanks.h>

#include <vector>

namespace chaindrive::contact
{
/// Elastic flanks whose surface is the exact arcs of a tooth form. Facets form a grid, columns
/// along the profile by layers along the axis.
class ArcFlanks : public ElasticFlanks
{
public:
  /// @p rim is that of the sprocket of @p family.
  ArcFlanks(const scene::ToothFamily &family, const World &world, const Rim &rim);

  ClosedSide closed_side(const World              &world,
                         double                    stiffness,
                         const mesh::SurfaceNodes &slaves,
                         const BodyBatches        &of_slaves) const override;

  std::vector<BodyBatches::Place> nodes_of_gap(unsigned int gap) const override;

private:
  Facet nearest(const dealii::Tensor<1, 3> &x,
                double                      within,
                unsigned int               &hint,
                Projection                 &projection) const override;

  /// Where the x component of a node stands in the vectors of the copies.
  std::size_t place(const unsigned int sector, const unsigned int c, const unsigned int k) const
  {
    return place_[sector * nodes_.size() + k * angle_.size() + c];
  }

  /// The same for the node in the next sector that is one with it, or for itself.
  std::size_t twin(const unsigned int sector, const unsigned int c, const unsigned int k) const
  {
    const unsigned int last = angle_.size() - 1;
    if (c > 0 && c < last)
      return place(sector, c, k);
    const unsigned int n = place_.size() / nodes_.size();
    return c == 0 ? place((sector + n - 1) % n, last, k) : place((sector + 1) % n, 0, k);
  }

  /// Node of a sector in column @p c and layer @p k of the flanks' nodes.
  unsigned int node(const unsigned int c, const unsigned int k) const
  {
    return nodes_[k * angle_.size() + c];
  }

  std::vector<unsigned int>         nodes_;  ///< [layer][column]
  std::vector<double>               angle_;  ///< per column, polar, in sector 0, ascending, rad
  std::vector<dealii::Tensor<1, 2>> column_; ///< x and y in sector 0, m
  std::vector<double>               z_;      ///< per layer, ascending, m
  std::vector<std::size_t>          place_;  ///< [sector][layer][column]: of x in the vectors
};
} // namespace chaindrive::contact
