// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/elastic_flanks.h>

#include <vector>

namespace chaindrive::contact
{
/// Elastic flanks whose surface is that of a mesh: see mesh::FacetSurface.
class FacetFlanks : public ElasticFlanks
{
public:
  /// The facets of @p family are those of the mesh that the rim's copies are made of.
  FacetFlanks(const scene::ToothFamily &family, const World &world, const Rim &rim);

  ClosedSide closed_side(const World              &world,
                         double                    stiffness,
                         const mesh::SurfaceNodes &slaves,
                         const BodyBatches        &of_slaves) const override;

  std::vector<BodyBatches::Place> nodes_of_gap(unsigned int gap) const override
  {
    return in_gap_[gap];
  }

private:
  /// Facets are looked for up to two radii from a slave.
  double beyond(const double radius) const override { return 2. * radius + longest_; }

  Facet nearest(const dealii::Tensor<1, 3> &x,
                double                      within,
                unsigned int               &hint,
                Projection                 &projection) const override;

  /// By vertices of the mesh; those that are not on the flanks have none.
  std::vector<std::size_t>      place_;    ///< of the x component in the vectors
  std::vector<dealii::Point<3>> position_; ///< in the hub's frame, m

  std::vector<std::vector<BodyBatches::Place>> in_gap_;       ///< [gap]
  double                                       longest_ = 0.; ///< diagonal of a facet, m
};
} // namespace chaindrive::contact
