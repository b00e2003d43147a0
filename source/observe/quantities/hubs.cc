// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/window_statistics.h>

#include <algorithm>

// How the two hubs turn, and the torques on them.

namespace chaindrive::observe
{
namespace
{
class Hubs : public Quantity
{
public:
  explicit Hubs(const Observation &now) : Quantity(now), statistics_(now, signals()) {}

  static bool exists(const Observation &start) { return !start.scene.sprockets.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const char *name : {"driver", "driven"})
      {
        const std::string path = std::string("hubs/") + name;
        contents.histories.push_back(
            {path + "_angle",
             "rad",
             "Rotation since the start, positive in the sense of the drive"});
        contents.histories.push_back(
            {path + "_speed", "rad/s", "Angular velocity in the sense of the drive"});
      }
    contents.histories.push_back(
        {"hubs/driver_torque",
         "N m",
         "Torque that the drive supplies, the driver's own inertia excluded"});
    contents.histories.push_back(
        {"hubs/load_torque", "N m", "Torque of the load against the driven hub"});
    contents.summary = WindowStatistics::members(signals());
    contents.summary.insert(contents.summary.end(),
                            {{"driven_angle_end", "rad", "angle of the driven sprocket at the end"},
                             {"driven_speed_mean", "rad/s", "driven speed, mean"},
                             {"driver_torque_mean", "N m", "driver torque, mean"}});
    return contents;
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    for (const scene::Sprocket &sprocket : now_.scene.sprockets)
      {
        const std::string  name  = sprocket.name();
        const unsigned int body  = sprocket.body;
        const int          sense = now_.scene.sense;
        channels.add("hubs/" + name + "_angle", [this, body, sense](const Channels::Row row) {
          row[0] = sense * hub_of(body).angle;
        });
        channels.add("hubs/" + name + "_speed", [this, body, sense](const Channels::Row row) {
          row[0] = sense * hub_of(body).speed;
        });
      }
    const load::Loads &loads = now_.system.loads;
    channels.add("hubs/driver_torque",
                 [&loads](const Channels::Row row) { row[0] = loads.driver_torque(); });
    channels.add("hubs/load_torque",
                 [&loads](const Channels::Row row) { row[0] = loads.load_torque(); });
  }

  void update() override
  {
    statistics_.add(
        {now_.scene.sense * hub_of(now_.scene.with(parameters::Role::driven).body).speed,
         now_.system.loads.driver_torque()});
  }

  void summarize(files::Json &summary) const override
  {
    summary["driven_angle_end"] =
        now_.scene.sense * hub_of(now_.scene.with(parameters::Role::driven).body).angle;
    summary["driven_speed_mean"]  = statistics_.mean("driven_speed");
    summary["driver_torque_mean"] = statistics_.mean("driver_torque");
    statistics_.summarize(summary);
  }

  void serialize(const Archive &archive) override { statistics_.serialize(archive / "statistics"); }

private:
  static std::vector<WindowStatistics::Signal> signals()
  {
    return {{"driven_speed", "rad/s", "driven speed"}, {"driver_torque", "N m", "driver torque"}};
  }

  const World::Hub &hub_of(const unsigned int body) const
  {
    return *std::find_if(now_.system.world.hubs.begin(),
                         now_.system.world.hubs.end(),
                         [body](const World::Hub &hub) { return hub.body == body; });
  }

  WindowStatistics statistics_;
};

const Registered<Hubs> registered_hubs("hubs", 10, parameters::QuantityGroup::speeds);
} // namespace
} // namespace chaindrive::observe
