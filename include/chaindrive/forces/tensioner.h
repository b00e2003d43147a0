// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/forces/force_element.h>

namespace chaindrive
{
/// What presses an arm or a slide (World::hubs) of a tensioner: the force of its law, between its
/// body and the ground.
class TensionerSpring : public ForceElement
{
public:
  explicit TensionerSpring(const scene::Tensioner &scene) : scene_(scene) {}

  std::unique_ptr<ForceElement> clone() const override;
  std::string                   name() const override { return "tensioner"; }
  void                          add_forces(World &world, double dt) override;
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive) override;

private:
  scene::Tensioner scene_;
  double           travel_ = 0., viscous_ = 0.; ///< at the last evaluation
};

/// How a tensioner stands: rad, rad/s and N m of an arm, m, m/s and N of a slide.
struct TensionerState
{
  double travel, speed;
  double force; ///< of its spring, dampers and stops; positive takes up slack
};

TensionerState state_of(const scene::Tensioner &tensioner, const World &world);
} // namespace chaindrive
