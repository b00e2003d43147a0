// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/scene/scene.h>

#include <iosfwd>

namespace chaindrive::scene
{
/// Estimated CPU time [s] of one step of @p scene on one core, outputs not counted: a cost for each
/// kind of object, fitted to the figures of doc/performance.md. Within a factor of two on other
/// machines of its age.
double step_cost(const Scene &scene);

/// Prints who is there, how it moves, what touches what, every effect with the reason why it is on
/// or off, the memory of the state [bytes] and the estimated cost of @p n_steps steps.
void print_plan(std::ostream &out, const Scene &scene, std::size_t memory, unsigned long n_steps);
} // namespace chaindrive::scene
