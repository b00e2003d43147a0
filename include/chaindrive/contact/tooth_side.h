// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface.h>
#include <chaindrive/scene/interface.h>

namespace chaindrive::contact
{
/// One side of a rigid sprocket, as a body of revolution: a plane up to where the teeth are
/// rounded, and from there an arc of the radius R that is tangent to it, which at the tips stands
/// back by the relief b: the rounding begins sqrt(2 R b - b^2) below the tips (ISO 606, tooth side
/// radius and relief). The arc goes on beyond the tips, so that nothing that comes from there meets
/// an edge. The distance from it is smooth, and has a potential.
class ToothSide final : public Surface
{
public:
  /// At z > 0 if @p sign is +1, at z < 0 if it is -1; if it is 0, both, of which a point meets the
  /// one on whose half of the sprocket it is.
  ToothSide(const scene::ToothSideFamily &family, int sign);

  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                double                      radius,
                double                      within,
                unsigned int               &hint,
                Projection                 &projection) const override;

  bool needs_search() const override { return true; }
  bool is_near(const World                &world,
               const dealii::Tensor<1, 3> &x,
               double                      radius,
               double                      reach) const override;

  Facing facing() const override { return Facing::anywhere; }

private:
  /// Of the point @p local [m, in the sprocket's frame]: distance and, in that frame, normal.
  double distance(const dealii::Tensor<1, 3> &local, dealii::Tensor<1, 3> &normal) const;

  int    sign_;
  double z_;          ///< of the middle plane of the teeth in the sprocket's frame, m
  double half_width_; ///< m
  double from_;       ///< radius at which the rounding begins, m
  double radius_;     ///< of the rounding, m
};
} // namespace chaindrive::contact
