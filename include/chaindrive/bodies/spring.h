// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

namespace chaindrive
{
/// A spring between two bodies along one direction, as the critical time step sees it.
struct Spring
{
  static constexpr unsigned int ground = static_cast<unsigned int>(-1); ///< for the second one

  unsigned int         first, second;
  dealii::Tensor<1, 3> direction; ///< unit
  dealii::Tensor<1, 3> first_at;  ///< world points where it is fastened, m
  dealii::Tensor<1, 3> second_at;
  double               stiffness; ///< N/m
  double               damping;   ///< N s/m
  bool is_rotational = false;     ///< it resists rotation about its direction: N m, N m s per rad
  bool is_of_oval    = false;     ///< it resists the two modes of the oval that the first body may
                                  ///< become, alike, and has neither direction nor second body
};
} // namespace chaindrive
