// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/forces/force_element.h>

namespace chaindrive
{
/// What turns two bodies on mounts (World::hubs) against each other about the axis of the first
/// one: a moment that depends on the angle by which it has turned since the start, relative to the
/// second one, and one that depends on its speed. The first body gets the sum, the second one the
/// opposite.
class RotaryElement : public ForceElement
{
public:
  void add_forces(World &world, double dt) override;
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive) override;

protected:
  /// @p stiffness, @p damping: the largest ones, N m/rad and N m s/rad.
  RotaryElement(const unsigned int first,
                const unsigned int second,
                const double       stiffness,
                const double       damping)
      : first_(first), second_(second), stiffness_(stiffness), damping_(damping)
  {
  }

  struct Action
  {
    double elastic; ///< moment on the first body, N m
    double viscous; ///< moment against its motion, N m
    double energy;  ///< stored, J
  };

  /// At @p angle [rad] and @p speed [rad/s].
  virtual Action action(double angle, double speed) const = 0;

  unsigned int first_, second_;
  double       stiffness_, damping_;

private:
  double angle_ = 0., viscous_ = 0.; ///< at the last evaluation, rad and N m
};

/// A spring with a dashpot: an arm that is pressed against a chain, a shaft that yields. At the
/// relative angle phi the moment on the first body is
///
///   M = M0 - k phi - c phi'
class TorsionSpring : public RotaryElement
{
public:
  /// @param stiffness  k, N m/rad
  /// @param damping    c, N m s/rad
  /// @param preload    M0, N m
  TorsionSpring(const unsigned int first,
                const unsigned int second,
                const double       stiffness,
                const double       damping = 0.,
                const double       preload = 0.)
      : RotaryElement(first, second, stiffness, damping), preload_(preload)
  {
  }

  std::unique_ptr<ForceElement> clone() const override;
  std::string                   name() const override { return "torsion spring"; }

private:
  Action action(double angle, double speed) const override;

  double preload_; ///< N m
};

/// A stop: a spring with a dashpot that acts only beyond an angle, and never pulls.
class Stop : public RotaryElement
{
public:
  /// @param from       the relative angle since the start at which it begins, rad
  /// @param sign       +1: it resists greater angles, -1: smaller ones
  /// @param stiffness  N m/rad
  /// @param damping    N m s/rad, while it acts
  Stop(const unsigned int first,
       const unsigned int second,
       const double       from,
       const int          sign,
       const double       stiffness,
       const double       damping = 0.)
      : RotaryElement(first, second, stiffness, damping), from_(from), sign_(sign)
  {
  }

  std::unique_ptr<ForceElement> clone() const override;
  std::string                   name() const override { return "stop"; }

private:
  Action action(double angle, double speed) const override;

  double from_; ///< rad
  int    sign_;
};
} // namespace chaindrive
