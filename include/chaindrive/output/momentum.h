// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/system.h>

namespace chaindrive::output
{
/// The running balance of linear momentum of all free bodies: what they have gained is what weight,
/// drag and the two hubs gave them. The hubs' share is the force that their own contacts put on
/// them, turned round: the balance closes only if every contact and bar pulls both of its bodies
/// alike. Elastic rims hand the forces on their teeth to nodes, not to the hub: with them there is
/// no balance.
class MomentumBalance
{
public:
  /// Begins the balance at the present state.
  explicit MomentumBalance(const dynamics::System &system);

  /// Whether this scene has one.
  bool is_kept() const { return kept_; }

  /// Adds the impulse of the step of @p dt [s] that ended now; call it after every step.
  void add_step(const dynamics::System &system, double dt);

  /// Compares with the momentum at present.
  void check(const dynamics::System &system);

  /// Largest difference found by check() over the largest sum of all |m v|.
  double largest_imbalance() const { return moved_ > 0. ? largest_ / moved_ : 0.; }

private:
  dealii::Tensor<1, 3> external_force(const dynamics::System &system) const;
  dealii::Tensor<1, 3> momentum(const dynamics::System &system, double &moved) const;

  bool                 kept_;
  std::vector<char>    free_;                      ///< per body: not a hub
  dealii::Tensor<1, 3> start_, impulse_;           ///< N s
  dealii::Tensor<1, 3> force_;                     ///< at the end of the last step, N
  double               largest_ = 0., moved_ = 0.; ///< N s
};
} // namespace chaindrive::output
