// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/simulation.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace chaindrive
{
/// What a run costs, predicted from its own first steps and outputs: CPU time of all ranks together
/// [s] and memory [bytes].
struct Cost
{
  double        start_up        = 0.; ///< until the first step, as it was
  double        step            = 0.; ///< of a step, as timed
  double        change          = 1.; ///< cost of a step over the whole run over that
  unsigned long steps           = 0;  ///< of the run
  unsigned long timed           = 0;  ///< steps that were timed
  double        sample          = 0.; ///< of a sample of the histories
  double        samples         = 0.; ///< number of them
  double        files           = 0.; ///< to make, close and compress the file of the histories
  double        field_output    = 0.; ///< of a field output
  double        n_field_outputs = 0.; ///< number of them
  double        memory          = 0.; ///< peak of all processes

  double loop() const { return step * change * static_cast<double>(steps); }
  double outputs() const { return sample * samples + files + field_output * n_field_outputs; }
  double total() const { return start_up + loop() + outputs(); }
};

/// Runs the first steps of @p simulation, which has not begun, for at most a second of CPU time of
/// each rank, takes a few samples and a field output, and removes them. Leaves the simulation where
/// it has come to. Then prepares another one from the same @p folders: what the first had to
/// compute for all runs of its kind (statics/cache.h) is no cost of a run. @p before: CPU time of
/// this process until it began to prepare [s]. Collective.
Cost measure_cost(Simulation &simulation, const std::vector<std::string> &folders, double before);

/// The sentence of the plan.
void print(std::ostream &out, const Cost &cost, int ranks);
} // namespace chaindrive
