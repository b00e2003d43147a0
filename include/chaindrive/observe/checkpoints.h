// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/observer.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/files/checkpoint_file.h>
#include <chaindrive/files/log.h>
#include <chaindrive/observe/schedule.h>
#include <chaindrive/parameters/run.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace chaindrive::observe
{
/// Writes checkpoints, and stops the run when it is asked to: by a signal (utilities/signals.h) or
/// by the wall-clock limit. Two checkpoints are kept. It must be the last of a run's observers:
/// those before it have looked at the step that a checkpoint holds.
///
/// Ranks agree on a checkpoint at no cost, by dynamics::Request: it comes one step later.
class Checkpoints : public dynamics::Observer
{
public:
  /// Sections @p time and @p output, which must outlive this, say when they are due. Checkpoints
  /// hold the system and the @p observers, go to @p directory and belong to the parameters @p fixed
  /// (parameters::Input). The run has @p n_steps steps of @p dt [s].
  Checkpoints(const parameters::Time           &time,
              const parameters::Output         &output,
              std::string                       directory,
              std::string                       fixed,
              unsigned long                     n_steps,
              double                            dt,
              std::vector<dynamics::Observer *> observers,
              files::Log                       &log);

  void        observe(const dynamics::System &system,
                      unsigned long           step,
                      double                  dt,
                      dynamics::Services     &services) override;
  bool        asks_for_bodies() const override { return true; }
  std::string name() const override { return "checkpoints"; }
  void        serialize(const Archive &archive, const dynamics::System &system) override;

  /// Takes over the state of @p file, and removes what was written after it. Returns the number of
  /// steps done. InputError when it does not fit. Collective.
  unsigned long resume(dynamics::System &system, const files::CheckpointFile &file);

  /// A sentence that names the last checkpoint, or nothing.
  std::string last() const;

  /// A sentence that names the last checkpoint not later than @p time [s], or says that there is
  /// none.
  std::string last_valid(double time) const;

private:
  using Clock = std::chrono::steady_clock;

  /// What the observers remember, and the time that the run has taken up to now.
  void
  serialize_observers(const Archive &archive, const dynamics::System &system, PhaseTimer &timer);
  void write(const dynamics::System &system, unsigned long step, dynamics::Services &services);
  void ask(const World &world, dynamics::Services &services) const;
  bool past_wall_clock_limit() const;
  void say_why(double time);

  const parameters::Time           &time_;
  const parameters::Output         &output_;
  std::string                       directory_, fixed_;
  unsigned long                     n_steps_;
  double                            dt_;
  std::vector<dynamics::Observer *> observers_;
  files::Log                       &log_;
  Schedule                          schedule_;
  Clock::time_point                 began_, written_;
  std::string                       last_;
};

/// The checkpoint that @p resume asks for: `auto`, a file, which must lie in @p directory, or its
/// name there; null when nothing is asked for, or nothing is there. @p fixed as above. `auto` takes
/// the older one when the newest is damaged, and says so. InputError when it cannot be used.
std::unique_ptr<files::CheckpointFile> find_checkpoint(const std::string &resume,
                                                       const std::string &directory,
                                                       const std::string &fixed,
                                                       files::Log        &log);
} // namespace chaindrive::observe
