// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>
#include <chaindrive/utilities/message_tags.h>
#include <chaindrive/utilities/to_first_rank.h>

#include <algorithm>

// How the rollers move that histories are asked for; of a chain without rollers its bushes.

namespace chaindrive::observe
{
namespace
{
class Rollers : public Quantity
{
public:
  using Quantity::Quantity;

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return start.scene.drive.n_joints > 0; }

  static Contents contents()
  {
    Contents contents;
    for (const std::string axis : {"x", "y"})
      {
        contents.histories.push_back({"rollers/position_" + axis, "m", "Centre of mass"});
        contents.histories.push_back({"rollers/velocity_" + axis, "m/s", "Of the centre of mass"});
        contents.histories.push_back(
            {"rollers/acceleration_" + axis, "m/s2", "Of the centre of mass"});
      }
    contents.histories.push_back(
        {"rollers/position_z", "m", "Centre of mass, where wheels are out of line"});
    contents.histories.push_back(
        {"rollers/spin", "rad/s", "Angular velocity, counter-clockwise positive"});
    return contents;
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    const auto add = [&](const std::string &name, const auto &value_of) {
      channels.add(
          "rollers/" + name, labels_of(now_.rollers), [this, value_of](const Channels::Row row) {
            std::transform(now_.rollers.begin(), now_.rollers.end(), row.begin(), value_of);
          });
    };
    const std::vector<unsigned int> &bodies = now_.scene.drive.rollers;
    for (const unsigned int d : {0U, 1U})
      {
        const std::string axis = d == 0 ? "x" : "y";
        add("position_" + axis, [this, d](const unsigned int k) { return frame(k).position[d]; });
        add("velocity_" + axis, [this, d](const unsigned int k) { return frame(k).velocity[d]; });
        add("acceleration_" + axis, [this, d](const unsigned int k) { return acceleration(k, d); });
      }
    if (now_.scene.effects.is_on(model::Effect::misalignment))
      add("position_z", [this](const unsigned int k) { return frame(k).position[2]; });
    if (std::all_of(now_.roller_bodies.begin(),
                    now_.roller_bodies.end(),
                    [this](const unsigned int k) { return turns(now_.scene.bodies[k]); }))
      add("spin", [this, &bodies](const unsigned int k) {
        const World &world = now_.system.world;
        return world.is_nodal(bodies[k]) ? spin_of_nodes_[bodies[k]] :
                                           world.frames[bodies[k]].angular_velocity[2];
      });
  }

  /// Every rank looks at its own rollers that move by nodes and leaves zeros where others do.
  void gather() override
  {
    const World &world = now_.system.world;
    dynamics::accelerations(world, acceleration_);
    if (std::none_of(now_.roller_bodies.begin(),
                     now_.roller_bodies.end(),
                     [&world](const unsigned int k) { return world.is_nodal(k); }))
      return;
    spin_of_nodes_.assign(world.n_bodies(), 0.);
    for (const unsigned int k : now_.roller_bodies)
      if (world.is_nodal(k) && world.owns(k))
        spin_of_nodes_[k] = spin_of_nodes(now_.system, k);
    on_first_rank_.sum(spin_of_nodes_, world.communicator(), tag_roller_spins);
  }

private:
  /// Whether @p roller has an angular velocity: a lumped one only where its ring turns.
  static bool turns(const scene::Body &roller)
  {
    return roller.motion != scene::Motion::lumped || roller.inertia[2] > 0. || roller.turns_with;
  }

  const Frame &frame(const unsigned int joint)
  {
    return now_.scene.drive.roller(joint, now_.system.world.frames, room_);
  }

  /// In the plane, of a bush of a link at the arm r from its centre of mass: a + z alpha x r -
  /// omega^2 r, alpha by the moment on the link.
  double acceleration(const unsigned int joint, const unsigned int d) const
  {
    const scene::DriveView &drive  = now_.scene.drive;
    const unsigned int      body   = drive.rollers[joint];
    const double            centre = acceleration_[3 * body + d];
    if (drive.bushes.empty())
      return centre;
    const World               &world = now_.system.world;
    const Frame               &frame = world.frames[body];
    const dealii::Tensor<1, 3> arm   = frame.rotation * drive.bushes[joint];
    const double               spin  = frame.angular_velocity[2];
    const double               growth =
        world.moment.local_element(3 * body + 2) / now_.scene.bodies[body].inertia[2];
    return centre + growth * (d == 0 ? -arm[1] : arm[0]) - spin * spin * arm[d];
  }

  Frame               room_;          ///< of a bush
  std::vector<double> acceleration_;  ///< of all bodies at the present sample
  std::vector<double> spin_of_nodes_; ///< of rollers that move by nodes, by body, rad/s
  SumOnFirstRank      on_first_rank_;
};

const Registered<Rollers> registered_rollers({"rollers", "How the rollers move.", {"shafts"}},
                                             parameters::QuantityGroup::roller_motion);
} // namespace
} // namespace chaindrive::observe
