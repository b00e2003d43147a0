// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/window_statistics.h>

#include <cmath>
#include <string>
#include <vector>

// What the chain does to the two shafts: the resultant of all contact forces on a sprocket.

namespace chaindrive::observe
{
namespace
{
class Shafts : public Quantity
{
public:
  explicit Shafts(const Observation &now)
      : Quantity(now)
      , statistics_(now, signals())
      , shafts_({Shaft(now, parameters::Role::driver), Shaft(now, parameters::Role::driven)})
  {
  }

  static bool exists(const Observation &start) { return !start.scene.teeth.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const std::string name : {"driver", "driven"})
      for (const char *axis : {"x", "y"})
        contents.histories.push_back({"hubs/" + name + "_load_" + axis,
                                      "N",
                                      "Force of the chain on the " + name + " shaft"});
    contents.summary = WindowStatistics::members(signals());
    return contents;
  }

  void add_channels(Channels &channels) override
  {
    for (const Shaft &shaft : shafts_)
      for (const unsigned int d : {0U, 1U})
        channels.add("hubs/" + shaft.name + (d == 0 ? "_load_x" : "_load_y"),
                     [&shaft, d](const Channels::Row row) { row[0] = shaft.load[d]; });
  }

  void update() override
  {
    for (Shaft &shaft : shafts_)
      shaft.look();
    statistics_.add({shafts_[0].load.norm(),
                     direction_of(shafts_[0], 1.),
                     shafts_[1].load.norm(),
                     direction_of(shafts_[1], -1.)});
  }

  void summarize(files::Json &summary) const override { statistics_.summarize(summary); }

  void serialize(const Archive &archive) override
  {
    for (Shaft &shaft : shafts_)
      archive(shaft.name + " load", shaft.load);
    statistics_.serialize(archive / "statistics");
  }

private:
  static std::vector<WindowStatistics::Signal> signals()
  {
    return {{"driver_load", "N", "load of the driver's shaft"},
            {"driver_load_direction", "rad", "direction of the load of the driver's shaft"},
            {"driven_load", "N", "load of the driven shaft"},
            {"driven_load_direction", "rad", "direction of the load of the driven shaft"}};
  }

  struct Shaft
  {
    Shaft(const Observation &now, const parameters::Role role) : name(text_of(role))
    {
      const unsigned int body = now.scene.with(role).body;
      for (const auto &family : now.system.contacts.families())
        if (const auto *found = dynamic_cast<const contact::SurfaceContact *>(family.get());
            found != nullptr && found->master() == body)
          teeth.push_back(found);
    }

    void look()
    {
      load = dealii::Tensor<1, 3>();
      for (const contact::SurfaceContact *family : teeth)
        for (const unsigned int i : family->near())
          load -= family->records()[i].force;
    }

    std::string                                  name; ///< driver | driven
    std::vector<const contact::SurfaceContact *> teeth;
    dealii::Tensor<1, 3>                         load; ///< N
  };

  /// From the line to the other shaft, which lies @p side along x, towards the tight span, rad.
  double direction_of(const Shaft &shaft, const double side) const
  {
    const double up = now_.scene.span_normal[1] < 0. ? -1. : 1.;
    return std::atan2(up * shaft.load[1], side * shaft.load[0]);
  }

  WindowStatistics   statistics_;
  std::vector<Shaft> shafts_; ///< driver first
};

const Registered<Shafts> registered_shafts("shafts", 15, parameters::QuantityGroup::tooth_forces);
} // namespace
} // namespace chaindrive::observe
