// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/window_statistics.h>
#include <chaindrive/utilities/batch_means.h>
#include <chaindrive/utilities/statistics.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

// The spans between the sprockets: what they pull, how fast they run, where they lie.

namespace chaindrive::observe
{
namespace
{
/// How long the largest tension of the start is looked for, s.
constexpr double start_time = 10e-3;

class SpansQuantity : public Quantity
{
public:
  explicit SpansQuantity(const Observation &now) : Quantity(now), statistics_(now, signals())
  {
    for (std::size_t s = 0; s < now.scene.drive.spans.size(); ++s)
      means_.push_back({WindowMean(now.window().start(), now.window().end()),
                        WindowMean(now.window().start(), now.window().end())});
    periods_.resize(means_.size());
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.drive.spans.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const std::string &name : known_spans())
      for (const auto &[history, value] : histories_of(name))
        contents.histories.push_back(history);
    contents.histories.insert(
        contents.histories.end(),
        {{"spans/tight_tension", "N", "Mean tension of the links in the middle of the tight span"},
         {"spans/slack_tension", "N", "Mean tension of the links in the middle of the slack span"},
         {"spans/tight_speed", "m/s", "Mean velocity of the tight span along itself"},
         {"spans/tight_offset",
          "m",
          "Mean distance of the tight span's middle from the driver's axis along the span normal"},
         {"spans/slack_offset",
          "m",
          "The same of the slack span, along its own normal and towards the tight span"}});
    contents.summary = WindowStatistics::members(signals());
    contents.summary.insert(
        contents.summary.end(),
        {{"spans/*/label", "", "tight or slack, by its mean tension, or nothing"},
         {"spans/*/tension_mean", "N", "tension of the span, mean"},
         {"spans/*/tension_uncertainty", "N", "of this mean: half of its 95 % confidence interval"},
         {"spans/*/speed_mean", "m/s", "speed of the span along itself, mean"},
         {"spans/*/speed_uncertainty",
          "m/s",
          "of this mean: half of its 95 % confidence interval"}});
    contents.summary.insert(contents.summary.end(),
                            {{"span_speed_mean", "m/s", "speed of the tight span, mean"},
                             {"tight_tension_mean", "N", "tension of the tight span, mean"},
                             {"slack_tension_mean", "N", "tension of the slack span, mean"},
                             {"tight_tension_max_start",
                              "N",
                              "tension of the tight span, largest in the first 10 ms"}});
    return contents;
  }

  void add_channels(Channels &channels) override
  {
    const auto add =
        [&](const files::Described &history, const unsigned int span, double Spans::Span::*value) {
          channels.add(history, [this, span, value](const Channels::Row row) {
            row[0] = now_.spans().of(span).*value;
          });
        };
    const std::vector<std::string> names = names_of(now_);
    for (unsigned int s = 0; s < names.size(); ++s)
      for (const auto &[history, value] : histories_of(names[s]))
        add(history, s, value);
    const auto label =
        [&](const std::string &name, const unsigned int span, double Spans::Span::*value) {
          channels.add("spans/" + name, [this, span, value](const Channels::Row row) {
            row[0] = now_.spans().of(span).*value;
          });
        };
    const auto tight = static_cast<unsigned int>(names.size() - 1);
    label("tight_tension", tight, &Spans::Span::tension);
    label("slack_tension", 0, &Spans::Span::tension);
    label("tight_speed", tight, &Spans::Span::speed);
    label("tight_offset", tight, &Spans::Span::offset);
    label("slack_offset", 0, &Spans::Span::inward);
  }

  void update() override
  {
    const Spans &spans = now_.spans();
    if (now_.time() - now_.scene.start_time <= start_time)
      tight_tension_start_ = std::max(tight_tension_start_, spans.tight().tension);
    statistics_.add({spans.tight().speed,
                     spans.tight().tension,
                     spans.slack().tension,
                     spans.tight().offset,
                     spans.slack().inward});
    const double from = now_.time() - now_.dt();
    for (unsigned int s = 0; s < means_.size(); ++s)
      {
        if (now_.window().settled()) // since when is not known from the start
          for (WindowMean *mean : {&means_[s].tension, &means_[s].speed})
            mean->move_to(now_.window().start(), now_.window().end());
        means_[s].tension.add(from, now_.dt(), spans.of(s).tension);
        means_[s].speed.add(from, now_.dt(), spans.of(s).speed);
        periods_[s].tension.add(spans.of(s).tension, now_.tooth_pieces());
        periods_[s].speed.add(spans.of(s).speed, now_.tooth_pieces());
      }
  }

  void summarize(files::Json &summary) const override
  {
    for (const char *name : {"span_speed", "tight_tension", "slack_tension"})
      summary[std::string(name) + "_mean"] = statistics_.mean(name);
    statistics_.summarize(summary);
    summary["tight_tension_max_start"] = tight_tension_start_;

    const auto by_tension = [](const Means &one, const Means &other) {
      return one.tension.mean() < other.tension.mean();
    };
    const auto [slack, tight] = std::minmax_element(means_.begin(), means_.end(), by_tension);
    const unsigned int least  = now_.window().pitches_per_period();
    for (auto means = means_.begin(); means != means_.end(); ++means)
      summary["spans"][now_.scene.drive.spans[means - means_.begin()].name] = {
          {"label",
           means == tight ? "tight" :
           means == slack ? "slack" :
                            ""},
          {"tension_mean", means->tension.mean()},
          {"tension_uncertainty",
           uncertainty_of_mean(periods_[means - means_.begin()].tension.values(), least)},
          {"speed_mean", means->speed.mean()},
          {"speed_uncertainty",
           uncertainty_of_mean(periods_[means - means_.begin()].speed.values(), least)}};
  }

  void serialize(const Archive &archive) override
  {
    archive("tight tension of the start", tight_tension_start_);
    statistics_.serialize(archive / "statistics");
    archive.numbers("means", means_);
    for (std::size_t s = 0; s < periods_.size(); ++s)
      {
        const Archive of_span = archive / ("tooth periods of span " + std::to_string(s));
        of_span("tension", periods_[s].tension);
        of_span("speed", periods_[s].speed);
      }
  }

private:
  static std::vector<std::string> names_of(const Observation &now)
  {
    std::vector<std::string> names;
    for (const scene::Span &span : now.scene.drive.spans)
      names.push_back(span.name);
    return names;
  }

  static std::vector<std::pair<files::Described, double Spans::Span::*>>
  histories_of(const std::string &name)
  {
    std::string title = name;
    std::replace(title.begin(), title.end(), '_', ' ');
    const std::string span = "the span from " + title;
    return {
        {{"spans/" + name + "_tension", "N", "Mean tension of the links in the middle of " + span},
         &Spans::Span::tension},
        {{"spans/" + name + "_speed", "m/s", "Mean velocity of " + span + " along itself"},
         &Spans::Span::speed},
        {{"spans/" + name + "_offset",
          "m",
          "Mean distance of the middle of " + span +
              " from the driver's axis along its outward normal"},
         &Spans::Span::offset}};
  }

  static std::vector<WindowStatistics::Signal> signals()
  {
    return {{"span_speed", "m/s", "speed of the tight span"},
            {"tight_tension", "N", "tension of the tight span"},
            {"slack_tension", "N", "tension of the slack span"},
            {"tight_offset", "m", "offset of the tight span"},
            {"slack_offset", "m", "offset of the slack span"}};
  }

  struct Means
  {
    WindowMean tension, speed;
  };

  struct Periods
  {
    RevolutionMeans tension, speed;
  };

  std::vector<Means>   means_;   ///< of each span
  std::vector<Periods> periods_; ///< its means over tooth periods
  WindowStatistics     statistics_;
  double               tight_tension_start_ = 0.; ///< largest, N
};

const Registered<SpansQuantity>
    registered_spans({"spans", "Tension, motion and sag of each span.", {"links"}},
                     parameters::QuantityGroup::tensions);
} // namespace
} // namespace chaindrive::observe
