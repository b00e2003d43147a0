// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/geometry.h>
#include <chaindrive/drive/ratings.h>
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/line_load.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>
#include <chaindrive/observe/window_statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// What each strand of a chain pulls and presses, where strands are separate.

namespace chaindrive::observe
{
namespace
{
class Strands : public Quantity
{
public:
  explicit Strands(const Observation &now)
      : Quantity(now), statistics_(now, signals(now.scene.n_strands()))
  {
    for (const scene::DriveView &view : now.scene.strands)
      {
        const auto find = [&](const scene::Interface interface, const unsigned int body) {
          return now.system.contacts.find({interface, body, view.strand});
        };
        Strand strand{Spans(now.scene, view, now.system), find(scene::Interface::bush_pin, 0), {}};
        for (const scene::Sprocket &sprocket : now.scene.drive.sprockets)
          {
            Wheel wheel{sprocket.body, find(scene::Interface::plate_teeth, sprocket.body)};
            for (const contact::Family *teeth : find(scene::Interface::roller_teeth, sprocket.body))
              wheel.contacts.push_back(teeth);
            strand.wheels.push_back(wheel);
          }
        strands_.push_back(std::move(strand));
      }
    values_.resize(strands_.size());
  }

  static bool exists(const Observation &start) { return !start.scene.strands.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const std::string &span : known_spans())
      contents.histories.push_back(tension_of(span));
    for (const std::string &wheel : known_sprockets())
      {
        contents.histories.push_back(tooth_force_of(wheel));
        contents.histories.push_back(side_force_of(wheel));
      }
    contents.histories.push_back(pin_load());
    contents.summary = WindowStatistics::members(signals(drive::most_strands));
    contents.summary.push_back(
        {"strands/uneven",
         "1",
         "mean tension of the tight span in the strand that pulls most, over that of all"});
    contents.summary.push_back({"strands/z/*", "m", "place of each strand along z"});
    contents.summary.push_back(
        {"strands/shown", "1", "the strand that stands for the chain in histories, from 1 on"});
    return contents;
  }

  void add_channels(Channels &channels) override
  {
    const std::vector<std::string> labels =
        labels_up_to(static_cast<unsigned int>(strands_.size()));
    const auto add = [&](const files::Described &history, const auto &value) {
      channels.add(history, labels, [this, value](const Channels::Row row) {
        std::transform(strands_.begin(), strands_.end(), row.begin(), value);
      });
    };
    const scene::DriveView &drive = now_.scene.drive;
    for (unsigned int s = 0; s < drive.spans.size(); ++s)
      add(tension_of(drive.spans[s].name),
          [s](const Strand &strand) { return strand.spans.of(s).tension; });
    for (unsigned int i = 0; i < drive.sprockets.size(); ++i)
      {
        add(tooth_force_of(drive.sprockets[i].name),
            [i](const Strand &strand) { return strand.wheels[i].on_teeth; });
        add(side_force_of(drive.sprockets[i].name),
            [i](const Strand &strand) { return strand.wheels[i].along; });
      }
    add(pin_load(), [](const Strand &strand) { return strand.pin_edge; });
  }

  void update() override
  {
    for (std::size_t s = 0; s < strands_.size(); ++s)
      {
        Strand &strand = strands_[s];
        strand.spans.update(now_.system);
        strand.pin_edge = 0.;
        for (const contact::Family *pins : strand.pins)
          strand.pin_edge = std::max(strand.pin_edge, largest_edge_load(*pins));
        for (Wheel &wheel : strand.wheels)
          {
            const dealii::Tensor<1, 3> axis =
                contact::axis_of(now_.system.world.frames[wheel.body], 2);
            wheel.along = wheel.on_teeth = 0.;
            for (const contact::Family *contact : wheel.contacts)
              for_each_near(*contact, [&](const contact::Record &record) {
                wheel.along -= record.force * axis;
                if (contact->interface().interface == scene::Interface::roller_teeth)
                  wheel.on_teeth += record.force * record.normal;
              });
          }
        values_[s] = strand.spans.tight().tension;
      }
    statistics_.add(values_);
  }

  void summarize(files::Json &summary) const override
  {
    statistics_.summarize(summary);
    std::vector<double> z;
    double              most = -std::numeric_limits<double>::infinity(), sum = 0.;
    std::size_t         shown = 0;
    for (std::size_t s = 0; s < strands_.size(); ++s)
      {
        const double mean = statistics_.mean(name_of(s));
        most              = std::max(most, mean);
        sum += mean;
        z.push_back(now_.scene.strands[s].z);
        if (now_.scene.strands[s].strand == 0)
          shown = s + 1;
      }
    summary["strands"] = {{"z", z},
                          {"shown", shown},
                          {"uneven", sum > 0. ? strands_.size() * most / sum : std::nan("")}};
  }

  void serialize(const Archive &archive) override
  {
    for (std::size_t s = 0; s < strands_.size(); ++s)
      {
        const Archive part = archive / std::to_string(s);
        part("pin edge", strands_[s].pin_edge);
        for (Wheel &wheel : strands_[s].wheels)
          {
            const Archive of_wheel = part / std::to_string(wheel.body);
            of_wheel("along", wheel.along);
            of_wheel("on teeth", wheel.on_teeth);
          }
      }
    statistics_.serialize(archive / "statistics");
  }

private:
  struct Wheel
  {
    unsigned int                         body;
    std::vector<const contact::Family *> contacts;
    double                               along = 0., on_teeth = 0.; ///< N
  };

  struct Strand
  {
    Spans                                spans;
    std::vector<const contact::Family *> pins;
    std::vector<Wheel>                   wheels;
    double                               pin_edge = 0.; ///< N/m
  };

  static std::string name_of(const std::size_t strand)
  {
    return "strand_" + std::to_string(strand + 1) + "_tension";
  }

  static std::vector<WindowStatistics::Signal> signals(const unsigned int n)
  {
    std::vector<WindowStatistics::Signal> signals;
    for (unsigned int s = 0; s < n; ++s)
      signals.push_back(
          {name_of(s), "N", "tension of the tight span in strand " + std::to_string(s + 1)});
    return signals;
  }

  static files::Described tension_of(const std::string &span)
  {
    return {"spans/" + span + "_tension_by_strand",
            "N",
            "Mean tension of the links in the middle of the span, of each strand where strands are "
            "separate"};
  }

  static files::Described tooth_force_of(const std::string &wheel)
  {
    return {"teeth/" + wheel + "_force_by_strand",
            "N",
            "Sum of the normal forces of rollers on the " + wheel +
                "'s teeth, of each strand where strands are separate"};
  }

  static files::Described side_force_of(const std::string &wheel)
  {
    return {"hubs/" + wheel + "_side_force_by_strand",
            "N",
            "Force of each strand on the " + wheel + " along its axis, where strands are separate"};
  }

  static files::Described pin_load()
  {
    return {"joints/pin_load_at_edge_by_strand",
            "N/m",
            "Largest load per length at an end of a pin in a bush, of each strand where strands "
            "are separate"};
  }

  WindowStatistics    statistics_;
  std::vector<Strand> strands_; ///< in the order of their places
  std::vector<double> values_;  ///< tensions of the tight span, N
};

const Registered<Strands>
    registered_strands({"strands", "What each strand pulls and presses.", {"spans", "sides"}},
                       parameters::QuantityGroup::tensions);
} // namespace
} // namespace chaindrive::observe
