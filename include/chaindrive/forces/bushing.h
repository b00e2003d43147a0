// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/forces/force_element.h>

#include <array>

namespace chaindrive
{
/// Springs with dashpots along the three axes between a point of one body and one of another, which
/// are in the same place at the start: a bearing or mount that yields. With d the way from the
/// second point to the first the force on the first body is -k d - c d', component by component.
class Bushing : public ForceElement
{
public:
  /// @param at  where the two points are at the start, m
  /// @param stiffness, damping  N/m and N s/m along x, y, z
  Bushing(unsigned int                first,
          unsigned int                second,
          const dealii::Point<3>     &at,
          const dealii::Tensor<1, 3> &stiffness,
          const dealii::Tensor<1, 3> &damping = {});

  std::unique_ptr<ForceElement> clone() const override;
  std::string                   name() const override { return "bushing"; }
  void                          add_forces(World &world, double dt) override;
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive) override;

  std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>> forces() const override;

private:
  /// Where the point of body @p i of the two is now, m.
  dealii::Tensor<1, 3> place_of(const World &world, unsigned int i) const;

  std::array<unsigned int, 2>         bodies_;
  dealii::Point<3>                    at_;
  dealii::Tensor<1, 3>                stiffness_, damping_;
  std::array<dealii::Tensor<1, 3>, 2> point_;                 ///< in the frames of the bodies, m
  bool                                placed_ = false;        ///< #point_ is known
  dealii::Tensor<1, 3>                way_, viscous_, force_; ///< at the last evaluation
};
} // namespace chaindrive
