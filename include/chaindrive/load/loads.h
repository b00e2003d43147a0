// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/drive/programs.h>

namespace chaindrive::load
{
/// All loads of the scene: gravity and drag on the chain, the load torque on the driven hub, and
/// the motion of the driver.
class Loads
{
public:
  explicit Loads(const scene::Scene &scene);

  /// Adds gravity, drag and the load torque at the present state and books the energy of gravity
  /// and drag. @p dt is the time since the last call [s].
  void add_forces(World &world, double dt);

  /// Books the work of both hubs once all forces on them are known; call it after every other
  /// add_forces() of a step.
  void add_work(World &world);

  void serialize(const Archive &archive);

  /// Of the driver at @p time [s], signed about +z: rad/s, and rad since the start.
  double driver_speed(const double time) const { return sense_ * programs_.speed->value(time); }
  double driver_angle(const double time) const
  {
    return sense_ * programs_.speed->integral(start_, time);
  }

  /// What acts on every node of an elastic body as it does on the others: gravity, m/s2 along -y,
  /// and drag, 1/s.
  double gravity() const { return gravity_; }
  double drag() const { return drag_; }

  /// Torque of the chain on the driver's contacts, what the drive must supply, N m (positive when
  /// it works in the sense of the drive).
  double driver_torque() const { return sense_ * drive_torque_; }

  /// Torque of the load on the driven hub, N m (positive when it resists).
  double load_torque() const { return -sense_ * load_torque_; }

private:
  drive::Programs programs_;
  double          start_; ///< time at which angles are 0, s
  double          gravity_, drag_;
  int             sense_;
  double          drive_torque_ = 0., load_torque_ = 0.; ///< signed about +z, N m
  double          drive_angle_ = 0., load_angle_ = 0.;   ///< at the last booking, rad
  bool            booked_ = false;
};
} // namespace chaindrive::load
