// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/quantity.h>
#include <chaindrive/scene/addition.h>

#include <algorithm>
#include <limits>
#include <string>

// By how much a sprocket turns out of step with the driver: the angle that gears without any error
// would not have. It shows the polygonal action of the chain and how its spans stretch.

namespace
{
using namespace chaindrive;

class TransmissionError : public observe::Quantity
{
public:
  struct Parameters
  {
    std::string sprocket = "driven";

    void declare(parameters::Declarations &declarations)
    {
      parameters::add_text(declarations,
                           "Sprocket",
                           sprocket,
                           "the name of a sprocket of the drive",
                           "Of which sprocket the transmission error is observed.");
    }
  };

  TransmissionError(const observe::Observation &now, const Parameters &parameters)
      : Quantity(now)
      , sprocket_(scene::find_sprocket(
            now.scene.drive, parameters.sprocket, "Quantities/transmission error/Sprocket"))
  {
  }

  static bool exists(const observe::Observation &start)
  {
    return !start.scene.drive.sprockets.empty();
  }

  static observe::Contents contents()
  {
    return {{{"hubs/transmission_error",
              "rad",
              "Angle of a sprocket less that of the driver over the ratio of teeth"}},
            {{"transmission_error_range",
              "rad",
              "transmission error in the window, largest less smallest"}}};
  }

  bool reads_contacts() const override { return false; }
  bool reads_bodies() const override { return false; } // of hubs all is known

  void add_channels(observe::Channels &channels) override
  {
    channels.add("hubs/transmission_error",
                 [this](const observe::Channels::Row row) { row[0] = error(); });
  }

  void update() override
  {
    if (now_.time() <= now_.window().start() || now_.time() > now_.window().end())
      return;
    least_ = std::min(least_, error());
    most_  = std::max(most_, error());
  }

  void summarize(files::Json &summary) const override
  {
    summary["transmission_error_range"] = nullptr; // before the window
    if (most_ >= least_)
      summary["transmission_error_range"] = most_ - least_;
  }

  void serialize(const Archive &archive) override
  {
    archive("least", least_);
    archive("most", most_);
  }

private:
  double angle(const scene::Sprocket &sprocket) const
  {
    for (const World::Hub &hub : now_.system.world.hubs)
      if (hub.body == sprocket.body)
        return sprocket.sense * hub.angle;
    return 0.;
  }

  double error() const
  {
    const scene::Sprocket &driver = now_.scene.drive.driver();
    return angle(sprocket_) - angle(driver) * driver.teeth / sprocket_.teeth;
  }

  const scene::Sprocket &sprocket_;
  double                 least_ = std::numeric_limits<double>::infinity(), most_ = -least_; ///< rad
};

const observe::Registered<TransmissionError> registered_transmission_error(
    {"transmission error", "By how much a sprocket turns out of step with the driver.", {"hubs"}},
    parameters::QuantityGroup::speeds);
} // namespace
