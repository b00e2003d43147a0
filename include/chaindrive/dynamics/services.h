// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/requests.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/timing.h>

namespace chaindrive::dynamics
{
class System;

/// What observers can ask for while they look at a system. Nothing of it changes the motion.
class Services
{
public:
  /// @p system must outlive this.
  explicit Services(System &system) : system_(system) {}

  /// The run ends with this step. To be called by all ranks at the same step.
  void stop_run() { stops_ = true; }
  bool stops() const { return stops_; }

  /// This rank asks for something, which asked() tells all ranks after the next step.
  void ask(Request request);
  bool asked(Request request) const;

  /// Brings frames, displacements, velocities and forces of all bodies up to the step, see
  /// Observer::asks_for_bodies().
  void update_bodies();

  /// Brings the contact records of all ranks to the first one (contact::Contacts). Collective.
  void gather_records();

  /// Writes the state of the system to @p archive, which must be one that is written. Collective.
  void write_state(const Archive &archive);

  /// Where the time that observers take is counted.
  PhaseTimer &timer();

private:
  System &system_;
  bool    stops_ = false;
};
} // namespace chaindrive::dynamics
