// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/forces/force_element.h>

#include <array>
#include <string>

namespace chaindrive
{
/// How a coupling stands: positive where it passes power on as it does while the drive drives.
struct CouplingState
{
  double twist;   ///< of what drives ahead of what is driven, rad; the static one included
  double speed;   ///< by which the twist grows, rad/s
  double elastic; ///< torque of its spring, N m
  double viscous; ///< torque of its damper, N m

  double torque() const { return elastic + viscous; }
};

CouplingState state_of(const scene::Coupling &coupling, const World &world);

/// The torsion spring and the damper of a coupling, between two bodies on mounts about z. With M0
/// the torque on the wheel at the start, about +z, and phi the angle of the wheel relative to what
/// is behind it since then, the wheel gets M = M0 - k phi - c phi' and the other one the opposite.
class CouplingSpring : public ForceElement
{
public:
  explicit CouplingSpring(const scene::Scene &scene, const scene::Coupling &coupling);

  std::unique_ptr<ForceElement> clone() const override;
  std::string                   name() const override { return name_; }
  void                          add_forces(World &world, double dt) override;
  std::optional<double>         lost() const override { return lost_; }
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive) override;

private:
  scene::Coupling coupling_;
  std::string     name_;
  double          twist_ = 0., viscous_ = 0.; ///< at the last evaluation
  double          lost_ = 0.;                 ///< J
};

/// How a bearing stands, along x and y.
struct BearingState
{
  std::array<double, 2> way;     ///< of the axis from where nothing pulls at it, m
  std::array<double, 2> speed;   ///< m/s
  std::array<double, 2> elastic; ///< force of the springs on the wheel, without its weight, N
  std::array<double, 2> viscous; ///< force of the dampers on the wheel, N

  double force(const unsigned int d) const { return elastic[d] + viscous[d]; }
};

BearingState state_of(const scene::Bearing &bearing, const World &world);

/// The springs and dampers of a bearing, on the two bodies that carry its wheel: with u the way of
/// its axis from where nothing but its weight G pulls at it, the wheel gets -k u - c u' along x
/// and y, and G along y.
class BearingSpring : public ForceElement
{
public:
  explicit BearingSpring(const scene::Scene &scene, const scene::Bearing &bearing);

  std::unique_ptr<ForceElement> clone() const override;
  std::string                   name() const override { return name_; }
  void                          add_forces(World &world, double dt) override;
  std::optional<double>         lost() const override { return lost_; }
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive) override;

private:
  scene::Bearing        bearing_;
  std::string           name_;
  std::array<double, 2> way_{}, viscous_{}; ///< at the last evaluation
  double                lost_ = 0.;         ///< J
};
} // namespace chaindrive
