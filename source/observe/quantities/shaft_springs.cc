// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/shaft.h>
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/window_statistics.h>

#include <cmath>
#include <string>
#include <vector>

// How couplings twist and bearings yield, and with what.

namespace chaindrive::observe
{
namespace
{
class ShaftSprings : public Quantity
{
public:
  explicit ShaftSprings(const Observation &now) : Quantity(now), statistics_(now, signals(now)) {}

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start)
  {
    return !start.scene.couplings.empty() || !start.scene.bearings.empty();
  }

  static Contents contents()
  {
    Contents contents;
    contents.histories                         = of_coupling(any_sprocket);
    const std::vector<files::Described> others = of_bearing(any_sprocket);
    contents.histories.insert(contents.histories.end(), others.begin(), others.end());
    std::vector<WindowStatistics::Signal> all = coupling_signals(any_sprocket);
    for (const WindowStatistics::Signal &signal : bearing_signals(any_sprocket))
      all.push_back(signal);
    contents.summary = WindowStatistics::members(all);
    return contents;
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    const World &world = now_.system.world;
    for (const scene::Coupling &coupling : now_.scene.couplings)
      {
        const std::vector<files::Described> histories = of_coupling(name_of(coupling.sprocket));
        channels.add(histories[0],
                     [&](const Channels::Row row) { row[0] = state_of(coupling, world).twist; });
        channels.add(histories[1], [&](const Channels::Row row) {
          row[0] = strands() * state_of(coupling, world).torque();
        });
        channels.add(histories[2],
                     [this, &coupling](const Channels::Row row) { row[0] = speed_of(coupling); });
      }
    for (const scene::Bearing &bearing : now_.scene.bearings)
      {
        const std::vector<files::Described> histories = of_bearing(name_of(bearing.sprocket));
        for (const unsigned int d : {0U, 1U})
          {
            channels.add(histories[d], [&world, &bearing, d](const Channels::Row row) {
              row[0] = state_of(bearing, world).way[d];
            });
            channels.add(histories[2 + d], [this, &world, &bearing, d](const Channels::Row row) {
              row[0] = strands() * state_of(bearing, world).force(d);
            });
          }
      }
  }

  void update() override
  {
    values_.clear();
    for (const scene::Coupling &coupling : now_.scene.couplings)
      {
        const CouplingState state = state_of(coupling, now_.system.world);
        values_.insert(values_.end(), {state.twist, strands() * state.torque()});
      }
    for (const scene::Bearing &bearing : now_.scene.bearings)
      {
        const BearingState state = state_of(bearing, now_.system.world);
        values_.insert(
            values_.end(),
            {state.way[0], state.way[1], strands() * std::hypot(state.force(0), state.force(1))});
      }
    statistics_.add(values_);
  }

  void summarize(files::Json &summary) const override { statistics_.summarize(summary); }

  void serialize(const Archive &archive) override { statistics_.serialize(archive / "statistics"); }

private:
  static std::vector<files::Described> of_coupling(const std::string &name)
  {
    const std::string path = "hubs/" + name;
    return {{path + "_coupling_twist",
             "rad",
             "Of what drives ahead of what is driven, while the drive drives; the static twist is "
             "part of it"},
            {path + "_coupling_moment", "N m", "Of its spring and damper, positive likewise"},
            {path + "_machine_velocity",
             "rad/s",
             "Of the motor or machine behind the coupling, in the sense of its motion in "
             "operation"}};
  }

  static std::vector<files::Described> of_bearing(const std::string &name)
  {
    const std::string path = "hubs/" + name;
    std::string       way  = "Of the wheel's axis from where the chain does not pull at it",
                force = "Of the bearing's springs and dampers on the wheel, its weight excluded";
    return {{path + "_displacement_x", "m", way},
            {path + "_displacement_y", "m", way},
            {path + "_bearing_force_x", "N", force},
            {path + "_bearing_force_y", "N", force}};
  }

  static std::vector<WindowStatistics::Signal> coupling_signals(const std::string &name)
  {
    return {{name + "_coupling_twist", "rad", "twist of the coupling of " + name},
            {name + "_coupling_moment", "N m", "torque of the coupling of " + name}};
  }

  static std::vector<WindowStatistics::Signal> bearing_signals(const std::string &name)
  {
    return {{name + "_displacement_x", "m", "displacement of the axis of " + name + " along x"},
            {name + "_displacement_y", "m", "displacement of the axis of " + name + " along y"},
            {name + "_bearing_force", "N", "magnitude of the bearing's force on " + name}};
  }

  static std::vector<WindowStatistics::Signal> signals(const Observation &now)
  {
    std::vector<WindowStatistics::Signal> signals;
    for (const scene::Coupling &coupling : now.scene.couplings)
      for (const auto &signal : coupling_signals(now.scene.drive.sprockets[coupling.sprocket].name))
        signals.push_back(signal);
    for (const scene::Bearing &bearing : now.scene.bearings)
      for (const auto &signal : bearing_signals(now.scene.drive.sprockets[bearing.sprocket].name))
        signals.push_back(signal);
    return signals;
  }

  const std::string &name_of(const unsigned int sprocket) const
  {
    return now_.scene.drive.sprockets[sprocket].name;
  }

  /// Torques and forces are those of all strands.
  double strands() const { return now_.scene.drive.strands; }

  double speed_of(const scene::Coupling &coupling) const
  {
    const double w = now_.system.world.frames[coupling.machine].angular_velocity[2];
    return now_.scene.drive.sprockets[coupling.sprocket].sense * w;
  }

  WindowStatistics    statistics_;
  std::vector<double> values_; ///< of the signals
};

const Registered<ShaftSprings>
    registered_shaft_springs({"shaft springs", "How couplings and bearings yield.", {"hubs"}},
                             parameters::QuantityGroup::speeds);
} // namespace
} // namespace chaindrive::observe
