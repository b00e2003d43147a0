// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/window_statistics.h>

#include <algorithm>

// How the hubs turn, and the torques on them.

namespace chaindrive::observe
{
namespace
{
class Hubs : public Quantity
{
public:
  explicit Hubs(const Observation &now)
      : Quantity(now), statistics_(now, signals(now.scene.drive.sprockets))
  {
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.drive.sprockets.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const parameters::Sprocket &sprocket : parameters::Sprockets().list)
      for (const files::Described &history : histories_of(sprocket.name, sprocket.role))
        contents.histories.push_back(history);
    for (const files::Described &history : histories_of(any_sprocket, parameters::Role::driven))
      contents.histories.push_back(history);
    contents.histories.push_back(
        {"hubs/load_torque", "N m", "The same as driven_torque, which it was called before"});
    contents.summary = WindowStatistics::members(signals(parameters::Sprockets().list));
    contents.summary.insert(contents.summary.end(),
                            {{"driven_angle_end", "rad", "angle of the driven sprocket at the end"},
                             {"driven_speed_mean", "rad/s", "driven speed, mean"},
                             {"driver_torque_mean", "N m", "driver torque, mean"}});
    return contents;
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    for (const scene::Sprocket &sprocket : now_.scene.drive.sprockets)
      {
        const auto histories = histories_of(sprocket.name, sprocket.role);
        channels.add(histories[0], [this, &sprocket](const Channels::Row row) {
          row[0] = sprocket.sense * hub_of(sprocket).angle;
        });
        channels.add(histories[1], [this, &sprocket](const Channels::Row row) {
          row[0] = sprocket.sense * hub_of(sprocket).speed;
        });
        if (histories.size() > 2)
          channels.add(histories[2],
                       [this, &sprocket](const Channels::Row row) { row[0] = torque(sprocket); });
      }
    channels.add("hubs/load_torque",
                 [this](const Channels::Row row) { row[0] = torque(now_.scene.drive.driven()); });
  }

  void update() override
  {
    values_.clear();
    for (const scene::Sprocket &sprocket : now_.scene.drive.sprockets)
      if (sprocket.role == parameters::Role::driven)
        values_.push_back(sprocket.sense * hub_of(sprocket).speed);
    values_.push_back(torque(now_.scene.drive.driver()));
    statistics_.add(values_);
  }

  void summarize(files::Json &summary) const override
  {
    const scene::Sprocket &driven = now_.scene.drive.driven();
    summary["driven_angle_end"]   = driven.sense * hub_of(driven).angle;
    summary["driven_speed_mean"]  = statistics_.mean(driven.name + "_speed");
    summary["driver_torque_mean"] = statistics_.mean("driver_torque");
    statistics_.summarize(summary);
  }

  void serialize(const Archive &archive) override { statistics_.serialize(archive / "statistics"); }

private:
  /// The speeds of all loads, and the torque of the driver.
  template <typename Sprockets>
  static std::vector<WindowStatistics::Signal> signals(const Sprockets &sprockets)
  {
    std::vector<WindowStatistics::Signal> signals;
    for (const auto &sprocket : sprockets)
      if (sprocket.role == parameters::Role::driven)
        signals.push_back({sprocket.name + "_speed", "rad/s", sprocket.name + " speed"});
    signals.push_back({"driver_torque", "N m", "driver torque"});
    return signals;
  }

  /// Of a sprocket: its angle, its speed and, if its shaft has one, its torque.
  static std::vector<files::Described> histories_of(const std::string     &name,
                                                    const parameters::Role role)
  {
    std::vector<files::Described> histories = {
        {"hubs/" + name + "_angle",
         "rad",
         "Rotation since the start, positive in the sense of its motion in operation"},
        {"hubs/" + name + "_speed", "rad/s", "Angular velocity in that sense"}};
    if (role == parameters::Role::driver)
      histories.push_back(
          {"hubs/" + name + "_torque",
           "N m",
           "Torque that the drive supplies, the " + name + "'s own inertia excluded"});
    else if (role == parameters::Role::driven)
      histories.push_back(
          {"hubs/" + name + "_torque", "N m", "Torque of the load against the " + name + " hub"});
    return histories;
  }

  /// What the shaft supplies, or with what it resists, for all strands.
  double torque(const scene::Sprocket &sprocket) const
  {
    const double given =
        now_.scene.drive.strands * sprocket.sense * now_.system.loads.torque(sprocket.shaft);
    return sprocket.role == parameters::Role::driver ? given : -given;
  }

  const World::Hub &hub_of(const scene::Sprocket &sprocket) const
  {
    return *std::find_if(now_.system.world.hubs.begin(),
                         now_.system.world.hubs.end(),
                         [&sprocket](const World::Hub &hub) { return hub.body == sprocket.body; });
  }

  WindowStatistics    statistics_;
  std::vector<double> values_; ///< of the signals
};

const Registered<Hubs> registered_hubs({"hubs", "How the sprockets turn, and the torques on them."},
                                       parameters::QuantityGroup::speeds);
} // namespace
} // namespace chaindrive::observe
