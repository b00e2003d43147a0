// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/quantity.h>

#include <string>

// Where arms are that move wheels, and what that takes.

namespace chaindrive::observe
{
namespace
{
class Swings : public Quantity
{
public:
  using Quantity::Quantity;

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.swings.empty(); }

  static Contents contents()
  {
    Contents contents;
    contents.histories = {turn_of(any_sprocket), moment_of(any_sprocket)};
    return contents;
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    for (const scene::Swing &swing : now_.scene.swings)
      {
        const std::string &name = now_.scene.drive.sprockets[swing.sprocket].name;
        channels.add(turn_of(name), [this, &swing](const Channels::Row row) {
          row[0] = now_.system.loads.prescribed_angle(swing.body, now_.system.world.time);
        });
        channels.add(moment_of(name), [this, &swing](const Channels::Row row) {
          row[0] = now_.scene.drive.strands * now_.system.loads.torque(swing.body);
        });
      }
  }

private:
  static files::Described turn_of(const std::string &name)
  {
    return {"hubs/" + name + "_swing",
            "rad",
            "Turn of the arm that moves the wheel, since the start, counter-clockwise positive"};
  }

  static files::Described moment_of(const std::string &name)
  {
    return {"hubs/" + name + "_swing_moment",
            "N m",
            "Of what moves that arm against the chain, about its pivot, counter-clockwise "
            "positive; without inertia and weight of arm and wheel"};
  }
};

const Registered<Swings>
    registered_swings({"swings", "Where prescribed arms are, and what moves them.", {"hubs"}},
                      parameters::QuantityGroup::speeds);
} // namespace
} // namespace chaindrive::observe
