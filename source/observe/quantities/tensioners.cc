// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/tensioner.h>
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

  static bool exists(const Observation &start) { return !start.scene.tensioners.empty(); }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    for (const scene::Tensioner &tensioner : now_.scene.tensioners)
      {
        const bool slides =
            now_.scene.bodies[tensioner.body].mount.kind == scene::Mount::Kind::prismatic;
        const std::string name = "hubs/" + now_.scene.drive.sprockets[tensioner.sprocket].name;
        channels.add(
            files::Described{
                name + "_travel",
                slides ? "m" : "rad",
                slides ? "Way of its slide from where its centre is given, positive where it "
                         "takes up slack" :
                         "Turn of its arm from where its centre is given, positive where it "
                         "takes up slack"},
            [this, &tensioner](const Channels::Row row) {
              row[0] = state_of(tensioner, now_.system.world).travel;
            });
        channels.add(
            files::Described{
                name + (slides ? "_tensioner_force" : "_tensioner_moment"),
                slides ? "N" : "N m",
                "Of the tensioner's spring, damper and stops, positive where it takes up "
                "slack"},
            [this, &tensioner](const Channels::Row row) {
              row[0] = state_of(tensioner, now_.system.world).force;
            });
      }
  }
};

const Registered<Tensioners>
    registered_tensioners({"tensioners", "Where tensioners are, and how they press.", {"hubs"}},
                          parameters::QuantityGroup::speeds);
} // namespace
} // namespace chaindrive::observe
