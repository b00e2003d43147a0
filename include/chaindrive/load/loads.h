// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/scene/scene.h>

#include <vector>

namespace chaindrive::load
{
/// All loads of the scene: gravity and drag on the chain, and what shafts give to bodies on hubs:
/// prescribed rotations, and torques against the others.
class Loads
{
public:
  explicit Loads(const scene::Scene &scene);

  /// Adds gravity and drag at the present state and books their energy. @p dt is the time since the
  /// last call [s].
  void add_forces(World &world, double dt);

  /// Adds the torques of shafts and books the work of all hubs once all forces on them are known;
  /// call it after every other add_forces() of a step.
  void add_work(World &world);

  void serialize(const Archive &archive);

  /// What is prescribed to @p body at @p time [s]: the angle since the start [rad] and the speed
  /// [rad/s], signed about its axis; zero without a shaft.
  double prescribed_angle(unsigned int body, double time) const;
  double prescribed_speed(unsigned int body, double time) const;

  /// What acts on every node of an elastic body as it does on the others: gravity, m/s2 along -y,
  /// and drag, 1/s.
  double gravity() const { return gravity_; }
  double drag() const { return drag_; }

  /// What the shaft of @p body gives to it, signed about +z, N m: where its rotation is prescribed,
  /// what the contacts on it take; zero without a shaft.
  double torque(unsigned int body) const;

private:
  struct State
  {
    scene::Shaft       given;
    functions::Pointer turn   = {}; ///< of an arm, in place of a speed: its angle over time
    double             torque = 0.; ///< signed about +z, N m
    double             angle  = 0.; ///< at the last booking, rad
  };

  const State *find(unsigned int body) const;

  std::vector<State> shafts_;
  double             start_; ///< time at which angles are 0, s
  double             gravity_, drag_;
  bool               booked_ = false;
};
} // namespace chaindrive::load
