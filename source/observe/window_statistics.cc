// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/window_statistics.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/exceptions.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <utility>

namespace chaindrive::observe
{
// a last step may end a little later than the run: a run that goes on counts all of it
WindowStatistics::WindowStatistics(const Observation &now, const std::vector<Signal> &signals)
    : now_(now), tooth_periods_(now.window().start(), now.window().end())
{
  const auto &hubs = now.system.world.hubs;
  const auto  driver =
      std::find_if(hubs.begin(), hubs.end(), [](const World::Hub &hub) { return hub.prescribed; });
  if (driver != hubs.end() && !now.scene.drive.sprockets.empty())
    {
      driver_ = &*driver;
      teeth_  = now.scene.drive.driver().sense * double(now.scene.drive.driver().teeth);
    }
  for (const Signal &signal : signals)
    items_.push_back({signal, SignalStatistics(now.window().start(), now.window().end()), {}});
}

void WindowStatistics::add(const double *values, [[maybe_unused]] const std::size_t n)
{
  Assert(n == items_.size(), dealii::ExcMessage("One value for each signal"));
  const Window &window = now_.window();
  const double  begin  = now_.time() - now_.dt();
  if (window.settled()) // since when is not known from the start
    {
      tooth_periods_.move_to(window.start(), window.end());
      for (Item &item : items_)
        item.statistics.move_to(window.start(), window.end());
    }
  const auto &pieces =
      tooth_periods_.next(begin, now_.dt(), driver_ != nullptr ? teeth_ * driver_->angle : 0.);
  pieces_ = &pieces;
  for (Item &item : items_)
    {
      item.statistics.add(begin, now_.dt(), *values, pieces);
      item.tooth_periods.add(*values++, pieces);
    }
}

double WindowStatistics::mean(const std::string &name) const
{
  return std::find_if(items_.begin(),
                      items_.end(),
                      [&name](const Item &item) { return item.signal.name == name; })
      ->statistics.mean();
}

void WindowStatistics::summarize(files::Json &summary) const
{
  files::Json &all         = summary["statistics"];
  all["tooth_periods"]     = tooth_periods_.n_revolutions();
  const unsigned int least = now_.window().pitches_per_period();
  for (const auto &[signal, statistics, periods] : items_)
    all[signal.name] = {{"unit", signal.unit},
                        {"mean", statistics.mean()},
                        {"uncertainty", uncertainty_of_mean(periods.values(), least)},
                        {"deviation", statistics.deviation()},
                        {"least", statistics.least()},
                        {"largest", statistics.largest()},
                        {"harmonics", statistics.harmonics(tooth_periods_.n_revolutions())}};
}

std::vector<files::Described> WindowStatistics::members(const std::vector<Signal> &signals)
{
  std::vector<files::Described> members;
  for (const Signal &signal : signals)
    {
      const std::string path = "statistics/" + signal.name + "/";
      members.push_back({path + "unit", "", "unit of all these"});
      for (const auto &[name, meaning] :
           {std::make_pair("mean", "mean"),
            std::make_pair("uncertainty", "of the mean: half of its 95 % confidence interval"),
            std::make_pair("deviation", "standard deviation"),
            std::make_pair("least", "least"),
            std::make_pair("largest", "largest"),
            std::make_pair("harmonics/*", "amplitudes of the first harmonics of the teeth")})
        members.push_back({path + name, signal.unit, signal.title + ", " + meaning});
    }
  members.push_back({"statistics/tooth_periods", "1", "whole tooth periods in the window"});
  return members;
}

void WindowStatistics::serialize(const Archive &archive)
{
  const Window &window = now_.window();
  const double  time   = now_.time();
  tooth_periods_.move_to(window.start(), window.end());
  archive("tooth periods", tooth_periods_.state());
  for (auto &[signal, statistics, periods] : items_)
    {
      archive(signal.name + " per tooth period", periods);
      statistics.move_to(window.start(), window.end());
      SignalStatistics earlier = statistics;
      archive(signal.name, earlier);
      if (archive.reads() && !statistics.go_on_from(earlier, time))
        throw InputError("its means up to " + to_text(time * 1e3) +
                         " ms belong to another window; leave Output/Window start in ms and "
                         "Window end in ms as they were");
    }
}
} // namespace chaindrive::observe
