// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface.h>
#include <chaindrive/scene/interface.h>

namespace chaindrive::contact
{
/// The flanks of a rigid sprocket, which are taken to go on beyond its width: the facets of its
/// mesh if it is an imported one, else its exact arcs.
class RigidFlanks : public Surface
{
public:
  explicit RigidFlanks(const scene::ToothFamily &family);

  /// See Touch for the feature: the gap between two teeth.
  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                double                      radius,
                double                      within,
                unsigned int               &hint,
                Projection                 &projection) const override;

  bool needs_search() const override { return true; }

  /// Slaves are near to the sprocket's circumference.
  bool is_near(const World                &world,
               const dealii::Tensor<1, 3> &x,
               double                      radius,
               double                      reach) const override;

  double half_width() const override { return family_.half_width; }
  bool   is_beside(const World &world, const dealii::Tensor<1, 3> &x) const override;

protected:
  /// The gap between two teeth that the point @p p [m, in the sprocket's frame] is nearest to.
  unsigned int gap_of(const dealii::Tensor<1, 3> &p) const;

  /// project() onto the sprocket as if it were rigid.
  Touch project_on_rigid(const World                &world,
                         const dealii::Tensor<1, 3> &x,
                         double                      radius,
                         double                      within,
                         unsigned int               &hint) const;

  scene::ToothFamily family_; ///< but for the slaves
};
} // namespace chaindrive::contact
