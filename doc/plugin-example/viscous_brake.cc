// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/force_element.h>
#include <chaindrive/scene/addition.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// A brake on the shaft of a sprocket: a fan or a dynamometer, whose torque grows with the speed.

namespace
{
using namespace chaindrive;

/// The torque M = -c w on a body that turns with the speed w about an axis that stands still.
class ViscousBrake : public ForceElement
{
public:
  /// @param damping  c, N m s
  ViscousBrake(const unsigned int body, const double damping) : body_(body), damping_(damping) {}

  std::unique_ptr<ForceElement> clone() const override
  {
    return std::make_unique<ViscousBrake>(*this);
  }
  std::string name() const override { return "viscous brake"; }

  void add_forces(World &world, const double dt) override
  {
    const World::Hub &hub    = hub_of(world);
    const double      torque = damping_ * hub.speed; // against the rotation
    for (unsigned int d = 0; d < 3; ++d)
      world.moment.local_element(3 * body_ + d) -= world.symmetry.share(torque) * hub.axis[d];
    if (dt > 0.) // by the trapezoidal rule, as all losses are
      world.ledger.spring_damping +=
          world.symmetry.share(0.5 * (torque_ + torque) * (hub.angle - angle_));
    angle_  = hub.angle;
    torque_ = torque;
  }

  /// A dashpot limits the step as a spring does. Its other end is the driver, whose motion is
  /// prescribed: nothing moves it.
  void add_springs(const World &world, std::vector<Spring> &springs) const override
  {
    const World::Hub &hub    = hub_of(world);
    const auto        ground = std::find_if(
        world.hubs.begin(), world.hubs.end(), [](const World::Hub &h) { return h.prescribed; });
    const dealii::Tensor<1, 3> &at = world.frames[body_].position;
    springs.push_back({body_, ground->body, hub.axis, at, at, 0., damping_, true});
  }

  void serialize(const Archive &archive) override
  {
    archive("angle", angle_);
    archive("torque", torque_);
  }

private:
  const World::Hub &hub_of(const World &world) const
  {
    return *std::find_if(world.hubs.begin(), world.hubs.end(), [this](const World::Hub &hub) {
      return hub.body == body_;
    });
  }

  unsigned int body_;
  double       damping_;
  double       angle_ = 0., torque_ = 0.; ///< at the last evaluation, rad and N m
};

struct Brake
{
  struct Parameters
  {
    std::string sprocket = "driven";
    double      damping  = 0.01; ///< N m s

    void declare(parameters::Declarations &declarations)
    {
      parameters::add_text(declarations,
                           "Sprocket",
                           sprocket,
                           "the name of a sprocket of the drive",
                           "On the shaft of which sprocket the brake is.");
      parameters::add(declarations,
                      "Damping in N m s",
                      damping,
                      parameters::unit::si,
                      parameters::at_least(0.),
                      "Torque of the brake over its angular velocity, c in M = c w.");
    }
  };

  static void add_to(scene::Scene &scene, const Parameters &parameters)
  {
    const scene::Sprocket &sprocket =
        scene::find_sprocket(scene.drive, parameters.sprocket, "Additions/viscous brake/Sprocket");
    scene.forces.push_back(std::make_shared<ViscousBrake>(sprocket.body, parameters.damping));
  }
};

const scene::Addition<Brake> registered_brake(
    {"viscous brake", "A brake on the shaft of a sprocket, whose torque grows with the speed."});
} // namespace
