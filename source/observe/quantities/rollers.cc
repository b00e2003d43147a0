// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>

#include <algorithm>

// How the rollers move that histories are asked for. Rollers are the bodies 0 ... N-1 in joint
// order.

namespace chaindrive::observe
{
namespace
{
class Rollers : public Quantity
{
public:
  using Quantity::Quantity;

  static bool exists(const Observation &start) { return start.scene.n_joints > 0; }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    const auto add = [&](const std::string &name,
                         const std::string &unit,
                         const std::string &description,
                         const auto        &value_of) {
      const unsigned int n = static_cast<unsigned int>(now_.rollers.size());
      channels.add({"rollers", name, unit, description, n, labels_of(now_.rollers)},
                   [this, value_of](const Channels::Row row) {
                     std::transform(
                         now_.rollers.begin(), now_.rollers.end(), row.begin(), value_of);
                   });
    };
    const std::vector<Frame> &frames = now_.system.world.frames;
    for (const unsigned int d : {0U, 1U})
      {
        const std::string axis = d == 0 ? "x" : "y";
        add("position_" + axis, "m", "Centre of mass", [&frames, d](const unsigned int k) {
          return frames[k].position[d];
        });
        add("velocity_" + axis, "m/s", "Of the centre of mass", [&frames, d](const unsigned int k) {
          return frames[k].velocity[d];
        });
        add("acceleration_" + axis,
            "m/s2",
            "Of the centre of mass",
            [this, d](const unsigned int k) { return acceleration_[3 * k + d]; });
      }
    if (std::all_of(now_.rollers.begin(), now_.rollers.end(), [this](const unsigned int k) {
          const scene::Body &roller = now_.scene.bodies[k];
          return roller.motion == scene::Motion::rigid || roller.inertia[2] > 0.;
        }))
      add("spin",
          "rad/s",
          "Angular velocity, counter-clockwise positive",
          [&frames](const unsigned int k) { return frames[k].angular_velocity[2]; });
  }

  void gather() override { dynamics::accelerations(now_.system.world, acceleration_); }

private:
  std::vector<double> acceleration_; ///< of all bodies at the present sample
};

const Registered<Rollers> registration("rollers", 20, parameters::QuantityGroup::roller_motion);
} // namespace
} // namespace chaindrive::observe
