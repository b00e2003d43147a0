// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/moving_facets.h>
#include <chaindrive/contact/surface.h>

#include <cstddef>
#include <vector>

namespace chaindrive::contact
{
/// A nearly flat side of one elastic body: MovingFacets through its nodes, wherever these are.
///
/// A slave at x = P + g n, with the point P of a facet and its normal n, gets the force
/// F = N n + T; the facet's nodes, whose weights are w_i, get -w_i F + g (T . grad w_i) n: forces
/// and moments cancel to round-off. The slip's velocity is the one on which T does their work.
class FaceSurface : public Surface
{
public:
  /// @p facets are those of the part of @p body, which is of @p group in World::copies; @p nodes
  /// are theirs in its fields, see NodeView. The facets must outlive the surface.
  FaceSurface(unsigned int             body,
              unsigned int             group,
              const MovingFacets      &facets,
              std::vector<std::size_t> nodes);

  /// The gap is along the facet's normal, and none is found where the point is not above any. The
  /// first tangent is along the line between two nodes of the side, and turns with it.
  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                double                      radius,
                double                      within,
                unsigned int               &hint,
                Projection                 &projection) const override;

  dealii::Tensor<1, 3> relative_velocity(const World                &world,
                                         const dealii::Tensor<1, 3> &x,
                                         const Projection           &projection,
                                         const dealii::Tensor<1, 3> &v,
                                         double                      dt) const override;

  dealii::Tensor<1, 3> slip_velocity(const World                &world,
                                     const Touch                &touch,
                                     const Projection           &projection,
                                     const dealii::Tensor<1, 3> &relative) const override;

  void add_opposite(World                      &world,
                    const dealii::Tensor<1, 3> &x,
                    const Touch                &touch,
                    const Projection           &projection,
                    const PointForce           &f) const override;

private:
  unsigned int             group_;
  const MovingFacets      &facets_;
  std::vector<std::size_t> nodes_;
};
} // namespace chaindrive::contact
