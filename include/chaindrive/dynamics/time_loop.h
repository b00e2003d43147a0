// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/observer.h>
#include <chaindrive/dynamics/system.h>

#include <vector>

namespace chaindrive::dynamics
{
/// Runs @p system from @p start to @p end [s] in steps of @p dt; time is start + step * dt. After
/// each step the @p observers look at it, one after the other. The last step is the first whose
/// time reaches the end, or that after which one of them stops the run. @p system has already gone
/// @p done steps. Returns the number of steps since the start.
unsigned long run(System                        &system,
                  const std::vector<Observer *> &observers,
                  double                         start,
                  double                         end,
                  double                         dt,
                  unsigned long                  done = 0);

/// A run of more steps than this would take days with the smallest model, years with the largest.
constexpr double most_steps = 1e11;

/// Number of steps that run() will take; InputError, with what to change, above #most_steps.
unsigned long n_steps(double start, double end, double dt);
} // namespace chaindrive::dynamics
