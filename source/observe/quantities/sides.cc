// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/geometry.h>
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/observe/known_names.h>
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
using Contact  = contact::SurfaceContact;
using Families = std::vector<const contact::Family *>;

/// The largest load [N/m] at an end of a line of contact of @p contact. Two neighbouring slaves of
/// a joint stand for each line, at the points of Gauss' rule: its load, linear along the line of
/// length L, is (F1 + F2 -+ sqrt(3) (F2 - F1)) / L at the ends.
/// Nodes of elastic bodies touch in many places, whose pressures are known: of them none is found.
double largest_edge_load(const contact::Family &family)
{
  const auto *points = dynamic_cast<const Contact *>(&family);
  if (points == nullptr || points->is_distributed())
    return 0.;
  const Contact                   &contact = *points;
  double                           largest = 0.;
  const std::vector<unsigned int> &near    = contact.near();
  const auto                      &records = contact.records();
  for (std::size_t n = 0; n + 1 < near.size(); ++n)
    {
      const unsigned int i = near[n], j = near[n + 1];
      if (records[i].joint != records[j].joint || records[i].slave != records[j].slave)
        continue;
      const dealii::Tensor<1, 3> sum    = records[i].force + records[j].force,
                                 differ = std::sqrt(3.) * (records[j].force - records[i].force);
      const double length =
          std::sqrt(3.) * std::abs(contact.slave(j).point[2] - contact.slave(i).point[2]);
      largest = std::max({largest, (sum - differ).norm() / length, (sum + differ).norm() / length});
    }
  return largest;
}

/// Calls @p visit for the records of @p family that the last search has left within reach.
template <typename Visit>
void for_each_near(const contact::Family &family, const Visit &visit)
{
  const auto &records = family.records();
  if (const auto *contact = dynamic_cast<const Contact *>(&family))
    for (const unsigned int i : contact->near())
      visit(records[i]);
  else
    std::for_each(records.begin(), records.end(), visit);
}

class Sides : public Quantity
{
public:
  explicit Sides(const Observation &now)
      : Quantity(now)
      , rigid_(!now.scene.tooth_sides.front().elastic)
      , statistics_(now, signals(names_of(now.scene.drive.sprockets), rigid_))
  {
    const auto find = [&now](const scene::InterfaceOf &interface) {
      return now.system.contacts.find(interface);
    };
    for (const scene::Sprocket &sprocket : now.scene.drive.sprockets)
      {
        wheels_.push_back({sprocket.name,
                           sprocket.body,
                           find({scene::Interface::plate_teeth, sprocket.body}),
                           find({scene::Interface::roller_teeth, sprocket.body})});
        add_kinds(wheels_.back().plates);
      }
    pins_ = find(scene::Interface::bush_pin);
    add_kinds(find(scene::Interface::plate_faces));
    add_kinds(find(scene::Interface::roller_ends));
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
      for_each_near(*kind.contact, [&kind](const contact::Record &record) {
        kind.penetration = std::max(kind.penetration, -record.gap);
      });
  }

  void summarize(files::Json &summary) const override
  {
    statistics_.summarize(summary);
    for (const Kind &kind : kinds_)
      summary["penetration_max"][kind.contact->name()] = kind.penetration;
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
      (archive / kind.contact->name())("overlap", kind.penetration);
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
    const contact::Family *contact;
    double                 penetration = 0.; ///< largest so far, m
  };

  void add_kinds(const Families &families)
  {
    for (const contact::Family *contact : families)
      kinds_.push_back({contact});
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
