// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/observation.h>
#include <chaindrive/observe/window.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::observe
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

enum Signal : unsigned int
{
  tight_tension,
  slack_tension,
  driven_speed,
  driver_torque,
  n_signals
};

std::vector<WindowMean> means_over(const double from, const double to)
{
  return std::vector<WindowMean>(n_signals, WindowMean(from, to));
}
} // namespace

Window::Window(const scene::Scene &scene, const Parameters &parameters)
    : waits_(!parameters.output.window_start)
    , open_(!waits_)
    , start_(parameters.output.window_start.value_or(infinity))
    , end_(parameters.output.window_end.value_or(infinity))
    , run_end_(parameters.time.end)
{
  if (!waits_)
    return;
  const parameters::Loads &loads = parameters.loads;
  const unsigned int       teeth = scene.with(parameters::Role::driver).teeth;
  radius_                        = 0.5 * scene.pitch / std::sin(dealii::numbers::PI / teeth);
  period_                        = 2. * dealii::numbers::PI / (teeth * loads.driver_speed);
  length_                        = parameters.output.window_pitches * period_;
  from_                          = parameters.time.start +
          std::max(scene.at_speed ? 0. : loads.ramp_time, loads.torque_step_time.value_or(0.));
  means_ = means_over(from_, from_ + period_);
}

void Window::look(const Observation &now)
{
  if (open_)
    return;
  add(now);
  while (!open_ && now.time() >= from_ + period_)
    next_period(now);
}

void Window::add(const Observation &now)
{
  if (!now.system.world.is_first_rank() || now.time() <= from_)
    return;
  const auto &hubs = now.system.world.hubs;
  const auto  driven =
      std::find_if(hubs.begin(), hubs.end(), [](const World::Hub &hub) { return !hub.prescribed; });
  const double begin = now.time() - now.dt();
  const auto   take  = [&](const Signal signal, const double value) {
    means_[signal].add(begin, now.dt(), value);
  };
  take(tight_tension, now.spans().tight_tension);
  take(slack_tension, now.spans().slack_tension);
  take(driven_speed, now.scene.sense * driven->speed);
  take(driver_torque, now.system.loads.driver_torque());
}

void Window::next_period(const Observation &now)
{
  const World &world = now.system.world;
  if (world.is_first_rank())
    {
      const auto   mean    = [this](const Signal signal) { return means_[signal].mean(); };
      const double tension = std::abs(mean(tight_tension)) + std::abs(mean(slack_tension));
      settling_.add(
          {mean(tight_tension) - mean(slack_tension), mean(driven_speed), mean(driver_torque)},
          {tension, 0.2 * std::abs(mean(driven_speed)), tension * radius_});
    }
  open_ = settling_.settled();
  if (n_ranks_in(world.communicator()) > 1)
    open_ = dealii::Utilities::MPI::broadcast(world.communicator(), open_);
  from_ += period_;
  if (open_)
    {
      start_ = from_;
      end_   = from_ + length_;
      return;
    }
  means_ = means_over(from_, from_ + period_);
  add(now); // the rest of this step
}

files::Json Window::summary(const double time) const
{
  files::Json window = {{"start", start_}, {"end", std::min(end_, run_end_)}, {"settled", nullptr}};
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
  archive("from", from_);
  archive.numbers("means", means_);
  settling_.serialize(archive / "settling");
  end_ = start_ + length_;
}
} // namespace chaindrive::observe
