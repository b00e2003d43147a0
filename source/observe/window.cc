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
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
} // namespace

Window::Window(const scene::Scene &scene,
               const Parameters   &parameters,
               const unsigned int  pitches_per_period)
    : waits_(!parameters.output.window_start)
    , open_(!waits_)
    , start_(parameters.output.window_start.value_or(infinity))
    , end_(parameters.output.window_end.value_or(infinity))
    , run_end_(parameters.time.end)
    , pitches_per_period_(pitches_per_period)
{
  if (!waits_)
    return;
  drift_.emplace(scene, parameters, pitches_per_period);
  double last = parameters.time.start;
  for (const scene::Shaft &shaft : scene.shafts)
    last = std::max(last, shaft.program.last_change(parameters.time.start));
  drift_->begin(last);
  unsigned int pitches = parameters.output.window_pitches;
  if (pitches_per_period > 1)
    pitches = std::max(pitches, judged_pitches());
  length_       = pitches * drift_->pitch_time();
  earliest_end_ = drift_->period_start() + judged_pitches() * drift_->pitch_time() + length_;
}

void Window::look(const Observation &now)
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
