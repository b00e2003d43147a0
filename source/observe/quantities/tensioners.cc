// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/tensioner.h>
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/quantity.h>

#include <string>
#include <vector>

// Where tensioners are, and with what force.

namespace chaindrive::observe
{
namespace
{
class Tensioners : public Quantity
{
public:
  using Quantity::Quantity;

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.tensioners.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const std::string &name :
         {std::string("hubs/") + any_sprocket, std::string("guides/") + any_span})
      for (const files::Described &history :
           {travel_of(name, "rad or m"), moment_of(name), force_of(name)})
        contents.histories.push_back(history);
    return contents;
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    for (const scene::Tensioner &tensioner : now_.scene.tensioners)
      {
        const bool slides =
            now_.scene.bodies[tensioner.body].mount.kind == scene::Mount::Kind::prismatic;
        const bool        guide = now_.scene.bodies[tensioner.body].kind == scene::Kind::guide;
        const std::string name  = guide ?
                                      "guides/" + now_.scene.drive.spans[tensioner.number].name :
                                      "hubs/" + now_.scene.drive.sprockets[tensioner.number].name;
        channels.add(travel_of(name, slides ? "m" : "rad"),
                     [this, &tensioner](const Channels::Row row) {
                       row[0] = state_of(tensioner, now_.system.world).travel;
                     });
        channels.add(
            slides ? force_of(name) : moment_of(name), [this, &tensioner](const Channels::Row row) {
              row[0] = now_.scene.drive.strands * state_of(tensioner, now_.system.world).force;
            });
      }
  }

private:
  static files::Described travel_of(const std::string &name, const std::string &unit)
  {
    return {name + "_travel",
            unit,
            "Turn of the tensioner's arm, or way of its slide, from where the centre of the wheel, "
            "or the line of the guide, is given, positive where it takes up slack"};
  }

  static files::Described force_of(const std::string &name)
  {
    // forces of guides on the chain end so
    const bool guide = name.compare(0, 7, "guides/") == 0;
    return {name + (guide ? "_tensioner_push" : "_tensioner_force"), "N", of_the_spring};
  }

  static files::Described moment_of(const std::string &name)
  {
    return {name + "_tensioner_moment", "N m", of_the_spring};
  }

  static constexpr const char *of_the_spring =
      "Of the tensioner's spring, damper and stops, positive where it takes up slack";
};

const Registered<Tensioners>
    registered_tensioners({"tensioners", "Where tensioners are, and how they press.", {"hubs"}},
                          parameters::QuantityGroup::speeds);
} // namespace
} // namespace chaindrive::observe
