// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/forces/force_element.h>

namespace chaindrive
{
/// A spring with a dashpot between two bodies that turn about one axis, or one that stands still:
/// an arm that is pressed against a chain, a shaft that yields. With phi the angle that the first
/// one has turned since the start, relative to the second one, about the axis of the first, the
/// moment on the first one is
///
///   M = M0 - k phi - c phi'
///
/// and on the second one -M.
class TorsionSpring : public ForceElement
{
public:
  /// Both bodies are on mounts (World::hubs).
  unsigned int first, second;
  double       stiffness;    ///< k, N m/rad
  double       damping = 0.; ///< c, N m s/rad
  double       preload = 0.; ///< M0, N m

  TorsionSpring(const unsigned int first,
                const unsigned int second,
                const double       stiffness,
                const double       damping = 0.,
                const double       preload = 0.)
      : first(first), second(second), stiffness(stiffness), damping(damping), preload(preload)
  {
  }

  std::unique_ptr<ForceElement> clone() const override;
  std::string                   name() const override { return "torsion spring"; }
  void                          add_forces(World &world, double dt) override;
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive) override;

private:
  double angle_ = 0., viscous_ = 0.; ///< at the last evaluation, rad and N m
};

/// A stop: a TorsionSpring without preload that acts only beyond an angle, on the side where the
/// first body turns further forward (or back, with a negative sign).
class Stop : public ForceElement
{
public:
  unsigned int first, second;
  double       from;         ///< the relative angle since the start at which it begins, rad
  int          sign;         ///< +1: it resists greater angles, -1: smaller ones
  double       stiffness;    ///< N m/rad
  double       damping = 0.; ///< N m s/rad, while it acts; it never pulls

  Stop(const unsigned int first,
       const unsigned int second,
       const double       from,
       const int          sign,
       const double       stiffness,
       const double       damping = 0.)
      : first(first), second(second), from(from), sign(sign), stiffness(stiffness), damping(damping)
  {
  }

  std::unique_ptr<ForceElement> clone() const override;
  std::string                   name() const override { return "stop"; }
  void                          add_forces(World &world, double dt) override;
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive) override;

private:
  double angle_ = 0., viscous_ = 0.; ///< at the last evaluation, rad and N m
};
} // namespace chaindrive
