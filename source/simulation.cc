// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/time_loop.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/simulation.h>
#include <chaindrive/statics/part_stiffness.h>
#include <chaindrive/utilities/ranks.h>

// READ THIS FILE FIRST. What flows through the program, in the order in which it does:
//
//   .prm -> Parameters -> Drive (with the stiffness of its parts) -> Scene -> System (World,
//   forces) -> time loop -> Summary
//
// run_command.cc puts files and the console around it.

namespace chaindrive
{
namespace
{
/// How well energy and momentum were balanced.
void add_balances(files::Json &values, const dynamics::Guard &guard)
{
  const double turned_over       = guard.energy().turned_over();
  values["energy_turned_over"]   = turned_over;
  values["energy_imbalance_max"] = nullptr; // unless there is something to compare with
  if (turned_over > 0.)
    values["energy_imbalance_max"] = guard.energy().largest_imbalance() / turned_over;
  if (guard.looks())
    {
      values["momentum_imbalance_max"] = guard.largest_momentum_error();
      values["energy_jump_max"]        = guard.largest_energy_jump();
    }
}
} // namespace

Simulation::Simulation(const Parameters               &parameters,
                       const std::vector<std::string> &folders,
                       const MPI_Comm                  comm)
    : parameters(parameters)
    , drive(drive::make_drive(parameters, statics::part_stiffness(parameters, comm)))
    , scene(scene::build_scene(parameters, drive, folders))
{
  if (!scene.has_elastic_bodies() && rank_in(comm) != 0)
    return;
  system_ = std::make_unique<dynamics::System>(scene,
                                               parameters.contact.search ==
                                                   parameters::Search::every_step,
                                               scene.has_elastic_bodies() ? comm : MPI_COMM_SELF);
  step    = dynamics::choose_step(*system_, parameters);
  guard_  = std::make_unique<dynamics::Guard>(
      scene, *system_, parameters.time.energy_limit, step.limit, parameters.time.guard);
  recorder_ = std::make_unique<observe::Recorder>(scene, parameters, *system_);
}

unsigned long Simulation::n_steps() const
{
  return dynamics::n_steps(parameters.time.start, parameters.time.end, step.step);
}

unsigned long Simulation::run(const std::vector<dynamics::Observer *> &others,
                              const unsigned long                      done)
{
  std::vector<dynamics::Observer *> all = observers();
  all.insert(all.end(), others.begin(), others.end());
  done_ = dynamics::run(*system_, all, parameters.time.start, parameters.time.end, step.step, done);
  return done_;
}

observe::Summary Simulation::summary() const
{
  observe::Summary summary;
  summary.phases      = observe::rows_of_all_ranks(system_->timer, communicator());
  files::Json &values = summary.values;
  recorder_->summarize(values);
  add_balances(values, *guard_);
  values["stable_step"]  = step.limit;
  values["step"]         = step.step;
  values["steps"]        = done_;
  values["window"]       = window().summary(system_->world.time);
  values["ranks"]        = n_ranks_in(communicator());
  values["memory_peak"]  = observe::memory_peak(communicator());
  values["wall_seconds"] = system_->timer.elapsed();
  values["cpu_seconds"]  = observe::cpu_seconds(summary.phases);
  values                 = observe::in_order(values);
  return summary;
}
} // namespace chaindrive
