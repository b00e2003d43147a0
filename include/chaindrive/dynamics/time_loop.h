// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/guard.h>
#include <chaindrive/dynamics/system.h>

namespace chaindrive::dynamics
{
/// Something that looks at the system after every step and never changes its motion.
class Observer
{
public:
  virtual ~Observer() = default;

  /// Called once before the first step and then after each; @p step counts from 0, @p dt is the
  /// step that led here [s], zero at the first call. All of the system belongs to
  /// system.world.time. Returns whether the run is to go on, on all ranks the same.
  virtual bool observe(System &system, unsigned long step, double dt) = 0;
};

/// Runs @p system from @p start to @p end [s] in steps of @p dt; time is start + step * dt. The
/// last step is the first whose time reaches the end, or that after which @p observer stops the
/// run. @p system has already gone @p done steps. Returns the number of steps since the start.
unsigned long run(System       &system,
                  Observer     &observer,
                  Guard        &guard,
                  double        start,
                  double        end,
                  double        dt,
                  unsigned long done = 0);

/// A run of more steps than this would take days with the smallest model, years with the largest.
constexpr double most_steps = 1e11;

/// Number of steps that run() will take; InputError, with what to change, above #most_steps.
unsigned long n_steps(double start, double end, double dt);
} // namespace chaindrive::dynamics
