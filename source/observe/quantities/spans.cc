// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/window_statistics.h>

#include <algorithm>
#include <string>

// The two spans between the sprockets: what they pull, how fast they run, where they lie.

namespace chaindrive::observe
{
namespace
{
/// How long the largest tension of the start is looked for, s.
constexpr double start_time = 10e-3;

class SpansQuantity : public Quantity
{
public:
  explicit SpansQuantity(const Observation &now) : Quantity(now), statistics_(now, signals()) {}

  static bool exists(const Observation &start) { return start.scene.n_joints > 0; }

  static Contents contents()
  {
    Contents contents;
    contents.histories = {
        {"spans/tight_tension", "N", "Mean tension of the links in the middle of the tight span"},
        {"spans/slack_tension", "N", "Mean tension of the links in the middle of the slack span"},
        {"spans/tight_speed", "m/s", "Mean velocity of the tight span along itself"},
        {"spans/tight_offset",
         "m",
         "Mean distance of the tight span's middle from the driver's axis along the span normal"},
        {"spans/slack_offset",
         "m",
         "The same of the slack span, along its own normal and towards the tight span"}};
    contents.summary = WindowStatistics::members(signals());
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
    const auto add = [&](const std::string &name, double Spans::*value) {
      channels.add("spans/" + name,
                   [this, value](const Channels::Row row) { row[0] = now_.spans().*value; });
    };
    add("tight_tension", &Spans::tight_tension);
    add("slack_tension", &Spans::slack_tension);
    add("tight_speed", &Spans::tight_speed);
    add("tight_offset", &Spans::tight_offset);
    add("slack_offset", &Spans::slack_offset);
  }

  void update() override
  {
    const Spans &spans = now_.spans();
    if (now_.time() - now_.parameters.time.start <= start_time)
      tight_tension_start_ = std::max(tight_tension_start_, spans.tight_tension);
    statistics_.add({spans.tight_speed,
                     spans.tight_tension,
                     spans.slack_tension,
                     spans.tight_offset,
                     spans.slack_offset});
  }

  void summarize(files::Json &summary) const override
  {
    for (const char *name : {"span_speed", "tight_tension", "slack_tension"})
      summary[std::string(name) + "_mean"] = statistics_.mean(name);
    statistics_.summarize(summary);
    summary["tight_tension_max_start"] = tight_tension_start_;
  }

  void serialize(const Archive &archive) override
  {
    archive("tight tension of the start", tight_tension_start_);
    statistics_.serialize(archive / "statistics");
  }

private:
  static std::vector<WindowStatistics::Signal> signals()
  {
    return {{"span_speed", "m/s", "speed of the tight span"},
            {"tight_tension", "N", "tension of the tight span"},
            {"slack_tension", "N", "tension of the slack span"},
            {"tight_offset", "m", "offset of the tight span"},
            {"slack_offset", "m", "offset of the slack span"}};
  }

  WindowStatistics statistics_;
  double           tight_tension_start_ = 0.; ///< largest, N
};

const Registered<SpansQuantity> registered_spans("spans", 40, parameters::QuantityGroup::tensions);
} // namespace
} // namespace chaindrive::observe
