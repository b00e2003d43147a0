// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/recorder.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>

namespace chaindrive::observe
{
namespace
{
constexpr const char *histories_name = "/histories";

/// At most one at every step, and one before the first.
std::size_t expected_samples(const model::Model &model, const unsigned long n_steps)
{
  const double intervals = (model.time.end - model.time.start) / model.output.history_interval;
  return static_cast<std::size_t>(std::min(intervals + 1., double(n_steps))) + 1;
}

/// The summary of what the @p quantities see before the first step: every mean has its member.
files::Json means_at_start(const std::vector<NamedQuantity> &quantities)
{
  files::Json summary;
  for (const NamedQuantity &item : quantities)
    item.quantity->summarize(summary);
  return summary;
}

/// The components of a unit vector as text, so that they read back exactly.
std::string axis_text(const dealii::Tensor<1, 3> &axis)
{
  return to_text(axis[0], 17) + " " + to_text(axis[1], 17) + " " + to_text(axis[2], 17);
}
} // namespace

Recorder::Recorder(const scene::Scene     &scene,
                   const model::Model     &model,
                   const dynamics::System &system,
                   PhaseTimer             &timer,
                   const unsigned int      pitches_per_period)
    : phase_(timer.add("Output"))
    , now_(scene, model, system, pitches_per_period)
    , quantities_(make_quantities(now_))
    , samples_(model.time.start, model.output.history_interval)
    , until_(model.output.until,
             model.output.until.empty() ? files::Json() : means_at_start(quantities_),
             pitches_per_period)
    , questions_(model.time.start, until_.is_asked() ? scene.pitch_time() : 0.)
    , reads_contacts_(now_.window().waits() || std::any_of(quantities_.begin(),
                                                           quantities_.end(),
                                                           [](const NamedQuantity &item) {
                                                             return item.quantity->reads_contacts();
                                                           }))
    , reads_bodies_(
          std::any_of(quantities_.begin(), quantities_.end(), [](const NamedQuantity &item) {
            return item.quantity->reads_bodies();
          }))
{
}

void Recorder::write_histories(const std::string  &directory,
                               const std::string  &parameter_text,
                               const unsigned long n_steps)
{
  takes_samples_ = true;
  if (!now_.system.world.is_first_rank())
    return;
  const scene::Span tight =
      now_.scene.drive.spans.empty() ? scene::Span{} : now_.scene.drive.tight();
  sampling_.emplace(
      std::make_unique<files::Histories>(
          directory + histories_name,
          std::vector<std::pair<std::string, std::string>>{
              {"program", std::string("chaindrive ") + version},
              {"parameters", parameter_text},
              {"parameter_hash", checksum(parameter_text)},
              {"span_direction", axis_text(tight.direction)},
              {"span_normal", axis_text(tight.normal)},
              {"axes", "driver at the origin, driven at (C, 0); z along the shafts; gravity -y"}},
          expected_samples(now_.model, n_steps),
          now_.model.output.csv),
      now_.model.output.precision == parameters::Precision::single);
  for (const NamedQuantity &item : quantities_)
    item.quantity->add_channels(sampling_->channels);
}

void Recorder::observe(const dynamics::System &system,
                       const unsigned long,
                       const double        dt,
                       dynamics::Services &services)
{
  const PhaseTimer::Scope scope(services.timer(), phase_);
  if (reads_contacts_) // at every step, since peaks, means and engagements are of every step
    services.gather_records();
  const bool sample = takes_samples_ && samples_.due(now_.time());
  if (reads_bodies_ || sample)
    services.update_bodies();
  now_.next(dt, &services);
  if (system.world.is_first_rank())
    for (const NamedQuantity &item : quantities_)
      item.quantity->update();

  if (sample)
    take_sample();
  if (questions_.due(now_.time()))
    {
      services.update_bodies();
      knows_enough_ = is_known() || knows_enough_;
    }
  if (knows_enough_ || now_.window().is_full(now_.time()))
    services.stop_run();
}

bool Recorder::is_known() const
{
  files::Json so_far;
  summarize(so_far);
  const World &world = now_.system.world;
  bool         known = world.is_first_rank() && Until::is_reached(so_far);
  if (n_ranks_in(world.communicator()) > 1)
    known = dealii::Utilities::MPI::broadcast(world.communicator(), known);
  return known;
}

void Recorder::take_sample()
{
  for (const NamedQuantity &item : quantities_)
    item.quantity->gather();
  if (!sampling_)
    return;
  sampling_->channels.sample(now_.time());
  for (const NamedQuantity &item : quantities_)
    item.quantity->begin_interval();
}

void Recorder::serialize(const Archive &archive, const dynamics::System &)
{
  now_.serialize(archive);
  for (const NamedQuantity &item : quantities_)
    item.quantity->serialize(archive / item.name);
  samples_.serialize(archive / "samples", now_.time());
  questions_.serialize(archive / "questions", now_.time());
  if (sampling_)
    sampling_->histories->serialize(archive / "histories");
}

void Recorder::check(const Archive &archive, const std::string &directory)
{
  files::Histories::check(directory + histories_name, archive / "histories");
}

std::string Recorder::close(const bool finished)
{
  if (!sampling_)
    return "";
  sampling_->histories->close();
  if (!finished)
    return "";
  std::string why_not = sampling_->histories->compress();
  if (why_not.empty()) // what may be lost there is still in these rows
    sampling_->histories->remove_saved();
  return why_not;
}

void Recorder::summarize(files::Json &summary) const
{
  for (const NamedQuantity &item : quantities_)
    item.quantity->summarize(summary);
  until_.summarize(summary);
}
} // namespace chaindrive::observe
