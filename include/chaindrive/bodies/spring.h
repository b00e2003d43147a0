// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

namespace chaindrive
{
/// A spring between two bodies along one direction, as the stable step sees it.
struct Spring
{
  unsigned int         first, second;
  dealii::Tensor<1, 3> direction; ///< unit
  dealii::Tensor<1, 3> first_at;  ///< world points where it is fastened, m
  dealii::Tensor<1, 3> second_at;
  double               stiffness; ///< N/m
  double               damping;   ///< N s/m
  bool turning = false; ///< it resists turning about its direction instead: N m and N m s per rad
};
} // namespace chaindrive
