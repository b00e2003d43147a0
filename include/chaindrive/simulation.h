// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/checks.h>
#include <chaindrive/drive/design_life.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/dynamics/guard.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/model/model.h>
#include <chaindrive/observe/recorder.h>
#include <chaindrive/observe/summary.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/announce.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive
{
/// One run of a drive from parameters to a summary, without files and console:
///
///     Simulation simulation(parameters, {"."}, MPI_COMM_WORLD);
///     simulation.run();
///     std::cout << simulation.summary().values["driven_speed_mean"];
///
/// Whoever wants more of the run hands in observers (commands.h).
class Simulation
{
public:
  /// Prepares a run: the drive, its scene, the state at the start and the step. Meshes are looked
  /// for in @p folders. Elastic bodies are distributed over the ranks of @p comm; lumped and rigid
  /// models are too small for that: the first rank computes them alone and the others are idle.
  /// InputError for what cannot be run. @p announce is told what takes long in it. Collective. @p
  /// parameters must outlive this.
  Simulation(const Parameters               &parameters,
             const std::vector<std::string> &folders,
             MPI_Comm                        comm,
             const Announce                 &announce = {});

  /// Whether this rank has nothing to do. It then has nothing but drive and scene, and may not call
  /// what follows.
  bool is_idle() const { return system_ == nullptr; }

  /// What looks at the system in any run: the guard, and the recorder of all quantities.
  std::vector<dynamics::Observer *> observers() { return {guard_.get(), recorder_.get()}; }

  /// Number of steps from the start to the end. InputError when they are too many.
  unsigned long n_steps() const;

  /// Runs to the end, or until one of the observers stops it; @p others look after observers(). The
  /// system has already gone @p done steps. Returns the number of steps since the start.
  unsigned long run(const std::vector<dynamics::Observer *> &others = {}, unsigned long done = 0);

  /// Whether the run is over: at its end, or before it when its window is full or it knows what
  /// Output/Until asks for.
  bool is_finished() const
  {
    return done_ == n_steps() || recorder_->knows_enough() || window().is_full(system_->world.time);
  }

  /// How long the chain lasts, in closed form.
  drive::DesignLife life() const;

  /// The window of the averages.
  const observe::Window &window() const { return recorder_->window(); }

  /// What the run has come to so far. Collective.
  observe::Summary summary() const;

  dynamics::System       &system() { return *system_; }
  const dynamics::System &system() const { return *system_; }
  observe::Recorder      &recorder() { return *recorder_; }

  /// The ranks that are not idle.
  MPI_Comm communicator() const { return system_->world.communicator(); }

  const Parameters  &parameters;
  const drive::Drive drive;
  const drive::Facts facts; ///< what to expect of it
  const model::Model model; ///< every decision, once
  const scene::Scene scene;
  stability::TimeStepChoice
      step; ///< may be changed before the run: one that is resumed keeps its step

private:
  Simulation(const Parameters               &parameters,
             const std::vector<std::string> &folders,
             const scene::BasisOf           &basis_of,
             MPI_Comm                        comm,
             const Announce                 &announce);
  Simulation(const Parameters                            &parameters,
             const std::vector<std::string>              &folders,
             const scene::BasisOf                        &basis_of,
             const std::pair<drive::Drive, model::Model> &decided,
             MPI_Comm                                     comm);

  std::unique_ptr<dynamics::System>  system_;
  std::unique_ptr<dynamics::Guard>   guard_;
  std::unique_ptr<observe::Recorder> recorder_;
  unsigned long                      done_ = 0; ///< steps since the start
};
} // namespace chaindrive
