// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/cost.h>
#include <chaindrive/files/temporary_directory.h>
#include <chaindrive/observe/field_output.h>
#include <chaindrive/observe/progress.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace chaindrive
{
namespace
{
/// Elastic bodies at speed touch and are searched more often than at the start, from which the cost
/// of a step is taken; that of lumped and rigid ones does not change. `scripts/cost.py --fit`
/// prints it from runs.
constexpr double change_of_elastic = 1.22;

/// Ends a run after a quarter of a second of CPU time, or where that were too few steps after a
/// second. Not timed are its first steps, in which everything is touched for the first time.
class Stopwatch : public dynamics::Observer
{
public:
  void observe(const dynamics::System &system,
               const unsigned long     step,
               const double,
               dynamics::Services &services) override
  {
    if (step < first || step % 4 != 0)
      return;
    const double now = PhaseTimer::total();
    if (step == first)
      begin_ = now;
    last_ = step;
    end_  = now;
    // every rank asks, so that all stop at the same step
    const double spent = dealii::Utilities::MPI::max(now - begin_, system.world.communicator());
    if (spent >= (steps() < enough ? longest : shortest))
      services.stop_run();
  }

  bool        asks_for_bodies() const override { return true; }
  std::string name() const override { return "stopwatch"; }

  unsigned long steps() const { return last_ > first ? last_ - first : 0; }
  double        seconds() const { return end_ - begin_; }

private:
  static constexpr unsigned long first = 8, enough = 32;
  static constexpr double        shortest = 0.25, longest = 1.; // s

  unsigned long last_  = 0;
  double        begin_ = 0., end_ = 0.;
};

double sum(const double value, const MPI_Comm comm)
{
  return dealii::Utilities::MPI::sum(value, comm);
}

/// CPU time of all ranks that @p work takes, s. Collective.
template <typename Work>
double cpu_time(const MPI_Comm comm, const Work &work)
{
  const double before = PhaseTimer::total();
  work();
  return sum(PhaseTimer::total() - before, comm);
}

/// CPU time that histories of @p n samples take from their first sample until they are closed, s.
double time_histories(Simulation &simulation, const std::string &folder, const unsigned int n)
{
  observe::Recorder &recorder = simulation.recorder();
  recorder.write_histories(folder, "", n);
  return cpu_time(simulation.communicator(), [&] {
    for (unsigned int i = 0; i < n; ++i)
      recorder.take_sample();
    recorder.close(true);
  });
}

void time_outputs(Simulation &simulation, Cost &cost)
{
  const MPI_Comm            comm   = simulation.communicator();
  const parameters::Output &output = simulation.parameters.output;
  const double      duration = simulation.parameters.time.end - simulation.parameters.time.start;
  dynamics::System &system   = simulation.system();
  const files::TemporaryDirectory scratch(comm);

  // a line through two numbers of samples: the file has its price whatever it holds
  constexpr unsigned int few = 8, many = 128;
  time_histories(simulation, scratch.path(), few); // all is touched for the first time
  const double first = time_histories(simulation, scratch.path(), few);
  cost.sample =
      std::max(0., time_histories(simulation, scratch.path(), many) - first) / (many - few);
  cost.files   = std::max(0., first - few * cost.sample);
  cost.samples = 1. + std::min(std::ceil(duration / output.history_interval), double(cost.steps));
  const double interval = simulation.model.field_interval;
  if (interval <= 0.)
    return;
  observe::FieldOutput field_output(
      simulation.scene, simulation.model, system, scratch.path(), system.timer);
  dynamics::Services services(system);
  cost.field_output    = cpu_time(comm, [&] { field_output.observe(system, 0, 0., services); });
  cost.n_field_outputs = 1. + std::min(std::floor(duration / interval), double(cost.steps));
}
} // namespace

Cost measure_cost(Simulation                     &simulation,
                  const std::vector<std::string> &folders,
                  const double                    before)
{
  const MPI_Comm comm = simulation.communicator();
  Cost           cost;
  cost.steps = simulation.n_steps();

  Stopwatch stopwatch;
  simulation.run({&stopwatch});
  cost.timed = stopwatch.steps();
  cost.step  = sum(stopwatch.seconds(), comm) / std::max(1UL, cost.timed);
  if (simulation.scene.has_elastic_bodies())
    cost.change = change_of_elastic;
  time_outputs(simulation, cost);
  cost.memory   = observe::memory_peak(comm);
  cost.start_up = sum(before, comm) + cpu_time(comm, [&] {
                    const Simulation another(simulation.parameters, folders, comm);
                  });
  return cost;
}

void print(std::ostream &out, const Cost &cost, const int ranks)
{
  out << "Cost: " << to_text(cost.total(), 3) << " s of CPU time"
      << (ranks > 1 ? " of " + std::to_string(ranks) + " ranks together" : "") << ": start-up "
      << to_text(cost.start_up, 2) << " s, " << cost.steps << " steps of "
      << to_text(cost.step * cost.change * 1e6, 3) << " us"
      << (cost.change != 1. ? " (" + to_text(cost.step * 1e6, 3) + " us at first)" : "") << ", "
      << to_text(cost.samples, 7) << " samples of " << to_text(cost.sample * 1e3, 2) << " ms";
  if (cost.n_field_outputs > 0.)
    out << ", " << to_text(cost.n_field_outputs, 7) << " field outputs of "
        << to_text(cost.field_output * 1e3, 2) << " ms";
  out << "; memory " << to_text(cost.memory / 1e6, 3) << " MB\n";
}
} // namespace chaindrive
