// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/observer.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/schedule.h>
#include <chaindrive/observe/until.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::observe
{
/// Keeps all quantities of a run up to date and, when asked to, samples them into histories.
/// Quantities see every step, histories only theirs. Every rank has one; the first writes.
class Recorder : public dynamics::Observer
{
public:
  /// The first three must outlive this. The time that it takes is counted by @p timer. @p
  /// pitches_per_period: see Observation.
  Recorder(const scene::Scene     &scene,
           const model::Model     &model,
           const dynamics::System &system,
           PhaseTimer             &timer,
           unsigned int            pitches_per_period);

  /// From now on samples go to @p directory, which must exist when the first is taken. The run will
  /// have @p n_steps steps; @p parameter_text is stored with the histories. Without this call there
  /// are no samples.
  void write_histories(const std::string &directory,
                       const std::string &parameter_text,
                       unsigned long      n_steps);

  /// The run ends when a window that begins with the settled drive is full, or when it knows what
  /// Output/Until asks for, which is looked at every pitch time.
  void        observe(const dynamics::System &system,
                      unsigned long           step,
                      double                  dt,
                      dynamics::Services     &services) override;
  bool        asks_for_bodies() const override { return true; }
  std::string name() const override { return "recorder"; }

  /// A sample of what was observed last; write_histories() must have been called. Collective.
  void take_sample();

  /// A resumed run may have another interval, but its window must be the same as far as it has gone
  /// (InputError).
  void serialize(const Archive &archive, const dynamics::System &system) override;

  /// InputError when the histories in @p directory are not those of @p archive, or are damaged.
  static void check(const Archive &archive, const std::string &directory);

  /// Writes what is left and closes the histories; those of a run that is @p finished are
  /// compressed, and what was kept to resume it is removed. Returns why they could not be
  /// compressed, a sentence, or nothing.
  std::string close(bool finished);

  /// The window of the averages.
  const Window &window() const { return now_.window(); }

  /// Whether the run knows what Output/Until asks for, and ends.
  bool knows_enough() const { return knows_enough_; }

  /// Adds what the quantities have to say of the run up to now. Collective.
  void summarize(files::Json &summary) const;

private:
  struct Sampling
  {
    Sampling(std::unique_ptr<files::Histories> files, const bool single)
        : histories(std::move(files)), channels(*histories, single)
    {
    }

    std::unique_ptr<files::Histories> histories;
    Channels                          channels;
  };

  /// Whether all that Output/Until asks for is known now. Collective.
  bool is_known() const;

  PhaseTimer::Phase          phase_;
  Observation                now_;
  std::vector<NamedQuantity> quantities_;
  Schedule                   samples_;
  Until                      until_;
  Schedule                   questions_; ///< when it is asked whether enough is known
  bool                       knows_enough_ = false;
  bool                       reads_contacts_; ///< see Quantity
  bool                       reads_bodies_;   ///< likewise
  bool                       takes_samples_ = false;
  std::optional<Sampling>    sampling_; ///< on the first rank
};
} // namespace chaindrive::observe
