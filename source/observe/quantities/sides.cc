// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/geometry.h>
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/line_load.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>
#include <chaindrive/observe/window_statistics.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// What wheels that are out of line do to the chain: forces along their axes, and loads at the ends
// of lines of contact.

namespace chaindrive::observe
{
namespace
{
using Families = std::vector<const contact::Family *>;

class Sides : public Quantity
{
public:
  explicit Sides(const Observation &now)
      : Quantity(now)
      , rigid_(!now.scene.tooth_sides.front().elastic)
      , statistics_(now, signals(names_of(now.scene.drive.sprockets), rigid_))
  {
    const auto find = [&now](const scene::InterfaceOf &interface) {
      return now.system.contacts.find_all(interface);
    };
    for (const scene::Sprocket &sprocket : now.scene.drive.sprockets)
      {
        wheels_.push_back({sprocket.name,
                           sprocket.body,
                           find({scene::Interface::plate_teeth, sprocket.body}),
                           find({scene::Interface::roller_teeth, sprocket.body})});
        add_kind(wheels_.back().plates);
      }
    pins_ = find(scene::Interface::bush_pin);
    add_kind(find(scene::Interface::plate_faces));
    add_kind(find(scene::Interface::roller_ends));
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.tooth_sides.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const std::string &name : known_sprockets())
      for (const files::Described &history : histories_of(name))
        contents.histories.push_back(history);
    contents.histories.push_back(of_links());
    contents.histories.push_back(of_pins());
    contents.summary =
        WindowStatistics::members(signals(names_of(parameters::Sprockets().list), true));
    std::vector<std::string> kinds = {parameters::text_of(scene::Interface::roller_ends)};
    for (const parameters::Sprocket &sprocket : parameters::Sprockets().list)
      kinds.push_back(scene::name_of_sides(sprocket.name));
    for (const std::string &kind : kinds)
      contents.summary.push_back(
          {"penetration_max/" + kind, "m", "penetration of the two sides, largest"});
    return contents;
  }

  void add_channels(Channels &channels) override
  {
    for (const Wheel &wheel : wheels_)
      {
        const auto histories = histories_of(wheel.name);
        channels.add(histories[0], [&wheel](const Channels::Row row) { row[0] = wheel.along; });
        channels.add(histories[1], [&wheel](const Channels::Row row) { row[0] = wheel.pressed; });
        if (rigid_)
          channels.add(histories[2], [&wheel](const Channels::Row row) { row[0] = wheel.edge; });
      }
    const std::vector<Frame> &frames = now_.system.world.frames;
    const auto               &links  = now_.scene.drive.links;
    channels.add(of_links(),
                 labels_up_to(static_cast<unsigned int>(links.size())),
                 [&frames, &links](const Channels::Row row) {
                   std::transform(links.begin(), links.end(), row.begin(), [&](const auto link) {
                     return frames[link].position[2];
                   });
                 });
    if (rigid_)
      channels.add(of_pins(), [this](const Channels::Row row) { row[0] = pin_edge_; });
  }

  void update() override
  {
    values_.clear();
    for (Wheel &wheel : wheels_)
      {
        const dealii::Tensor<1, 3> axis = contact::axis_of(now_.system.world.frames[wheel.body], 2);
        wheel.along = wheel.pressed = wheel.edge = 0.;
        for (const contact::Family *plates : wheel.plates)
          for_each_near(*plates, [&](const contact::Record &record) {
            wheel.along -= record.force * axis;
            wheel.pressed += record.force * record.normal;
          });
        for (const contact::Family *teeth : wheel.teeth)
          {
            for_each_near(
                *teeth, [&](const contact::Record &record) { wheel.along -= record.force * axis; });
            wheel.edge = std::max(wheel.edge, largest_edge_load(*teeth));
          }
        values_.insert(values_.end(), {wheel.along, wheel.pressed});
        if (rigid_)
          values_.push_back(wheel.edge);
      }
    pin_edge_ = 0.;
    for (const contact::Family *pins : pins_)
      pin_edge_ = std::max(pin_edge_, largest_edge_load(*pins));
    if (rigid_)
      values_.push_back(pin_edge_);
    statistics_.add(values_);
    for (Kind &kind : kinds_)
      for (const contact::Family *contact : kind.contacts)
        for_each_near(*contact, [&kind](const contact::Record &record) {
          kind.penetration = std::max(kind.penetration, -record.gap);
        });
  }

  void summarize(files::Json &summary) const override
  {
    statistics_.summarize(summary);
    for (const Kind &kind : kinds_)
      summary["penetration_max"][kind.name] = kind.penetration;
  }

  void serialize(const Archive &archive) override
  {
    for (Wheel &wheel : wheels_)
      {
        const Archive part = archive / wheel.name;
        part("along", wheel.along);
        part("pressed", wheel.pressed);
        part("edge", wheel.edge);
      }
    archive("pin edge", pin_edge_);
    for (Kind &kind : kinds_)
      (archive / kind.name)("overlap", kind.penetration);
    statistics_.serialize(archive / "statistics");
  }

private:
  struct Wheel
  {
    std::string  name;
    unsigned int body;
    Families     plates, teeth;
    double       along = 0., pressed = 0., edge = 0.; ///< N, N, N/m
  };

  struct Kind
  {
    std::string name;
    Families    contacts;
    double      penetration = 0.; ///< largest so far, m
  };

  /// Of one interface, of all strands.
  void add_kind(const Families &families)
  {
    if (!families.empty())
      kinds_.push_back({families.front()->name(), families});
  }

  template <typename Sprockets>
  static std::vector<std::string> names_of(const Sprockets &sprockets)
  {
    std::vector<std::string> names;
    names.reserve(sprockets.size());
    for (const auto &sprocket : sprockets)
      names.push_back(sprocket.name);
    return names;
  }

  /// Edge loads are those @p of_rigid bodies.
  static std::vector<WindowStatistics::Signal> signals(const std::vector<std::string> &names,
                                                       const bool                      of_rigid)
  {
    std::vector<WindowStatistics::Signal> signals;
    for (const std::string &name : names)
      {
        signals.push_back({name + "_side_force", "N", "side force on the " + name + "'s teeth"});
        signals.push_back({name + "_plate_force", "N", "plates on the " + name + "'s teeth"});
        if (of_rigid)
          signals.push_back(
              {name + "_load_at_edge", "N/m", "edge load on the " + name + "'s teeth"});
      }
    if (of_rigid)
      signals.push_back({"pin_load_at_edge", "N/m", "edge load on pins"});
    return signals;
  }

  static std::vector<files::Described> histories_of(const std::string &name)
  {
    return {{"hubs/" + name + "_side_force",
             "N",
             "Force of the chain on the " + name + " along its axis, where wheels are out of line"},
            {"hubs/" + name + "_plate_force",
             "N",
             "Sum of the normal forces of plates on the sides of the " + name + "'s teeth"},
            {"teeth/" + name + "_load_at_edge",
             "N/m",
             "Largest load per length at an end of a roller's line of contact with the " + name +
                 "'s teeth"}};
  }

  static files::Described of_links()
  {
    return {"links/position_z", "m", "Centre of mass, where wheels are out of line"};
  }

  static files::Described of_pins()
  {
    return {"joints/pin_load_at_edge",
            "N/m",
            "Largest load per length at an end of a pin in its bush, where wheels are out of line"};
  }

  bool                rigid_; ///< links
  WindowStatistics    statistics_;
  std::vector<Wheel>  wheels_;
  Families            pins_;
  std::vector<Kind>   kinds_;
  double              pin_edge_ = 0.; ///< N/m
  std::vector<double> values_;        ///< of the signals
};

const Registered<Sides>
    registered_sides({"sides",
                      "With what forces wheels that are out of line guide the chain.",
                      {"shafts", "joints"}},
                     parameters::QuantityGroup::tooth_forces);
} // namespace
} // namespace chaindrive::observe
