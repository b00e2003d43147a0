// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/services.h>
#include <chaindrive/utilities/archive.h>

#include <string>

namespace chaindrive::dynamics
{
class System;

/// Something that looks at the system after every step. It cannot change it; what it may ask for
/// are the Services.
class Observer
{
public:
  virtual ~Observer() = default;

  /// Called once before the first step and then after each; @p step counts from 0, @p dt is the
  /// step that led here [s], zero at the first call. All of the system belongs to
  /// system.world.time.
  virtual void observe(const System &system, unsigned long step, double dt, Services &services) = 0;

  /// Whether it calls Services::update_bodies() before it looks at frames, displacements,
  /// velocities, forces or spins of bodies; of hubs all is known anyway. Where all observers do,
  /// these are written in the steps only in which somebody reads them.
  virtual bool asks_for_bodies() const { return false; }

  /// What it is called in checkpoints.
  virtual std::string name() const = 0;

  /// What it remembers from step to step. Collective.
  virtual void serialize(const Archive &, const System &) {}
};
} // namespace chaindrive::dynamics
