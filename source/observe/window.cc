// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/observation.h>
#include <chaindrive/observe/window.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace chaindrive::observe
{
Window::Window(const scene::Scene &scene,
               const model::Model &model,
               const unsigned int  pitches_per_period)
    : waits_(model.window.waits)
    , open_(!waits_)
    , start_(model.window.start)
    , end_(model.window.end)
    , run_end_(model.time.end)
    , until_(!model.output.until.empty())
    , pitches_per_period_(pitches_per_period)
{
  if (!waits_)
    return;
  drift_.emplace(scene, pitches_per_period);
  double last = scene.start_time;
  for (const scene::Shaft &shaft : scene.shafts)
    last = std::max(last, shaft.program.last_change(scene.start_time));
  drift_->begin(last);
  unsigned int pitches = model.window.pitches;
  if (pitches_per_period > 1)
    pitches = std::max(pitches, judged_pitches());
  length_       = pitches * drift_->pitch_time();
  earliest_end_ = drift_->period_start() + judged_pitches() * drift_->pitch_time() + length_;
  if (until_) // as long as it takes
    length_ = std::numeric_limits<double>::infinity();
}

void Window::update(const Observation &now)
{
  if (open_)
    return;
  drift_->add(now);
  while (!open_ && now.time() >= drift_->period_end())
    next_period(now);
}

void Window::next_period(const Observation &now)
{
  const World &world = now.system.world;
  drift_->next_period(now);
  open_ = drift_->settled();
  if (n_ranks_in(world.communicator()) > 1)
    open_ = dealii::Utilities::MPI::broadcast(world.communicator(), open_);
  if (!open_)
    return;
  start_ = drift_->period_start();
  end_   = start_ + length_;
}

files::Json Window::summary(const double time) const
{
  files::Json window = {{"start", start_}, {"end", std::min(end_, run_end_)}, {"settled", nullptr}};
  if (until_)
    window["end"] = std::min({end_, run_end_, time});
  window["judged_pitches"] = judged_pitches();
  if (!waits_)
    return window;
  window["settled"] = open_;
  if (open_)
    window["end"] = std::min(end_, time);
  else
    window["start"] = window["end"] = nullptr;
  return window;
}

void Window::serialize(const Archive &archive)
{
  bool waits = waits_;
  archive("waits", waits);
  if (waits != waits_)
    throw InputError("its window begins " +
                     std::string(waits ? "when the drive has settled" : "at a given time") +
                     "; leave Output/Window start in ms as it was");
  if (!waits_)
    return;
  archive("open", open_);
  archive("start", start_);
  drift_->serialize(archive / "drift");
  end_ = start_ + length_;
}
} // namespace chaindrive::observe
