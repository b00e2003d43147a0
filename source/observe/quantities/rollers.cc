// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>

#include <deal.II/base/mpi.h>

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
            std::transform(
                now_.roller_bodies.begin(), now_.roller_bodies.end(), row.begin(), value_of);
          });
    };
    const std::vector<Frame> &frames = now_.system.world.frames;
    for (const unsigned int d : {0U, 1U})
      {
        const std::string axis = d == 0 ? "x" : "y";
        add("position_" + axis,
            [&frames, d](const unsigned int k) { return frames[k].position[d]; });
        add("velocity_" + axis,
            [&frames, d](const unsigned int k) { return frames[k].velocity[d]; });
        add("acceleration_" + axis,
            [this, d](const unsigned int k) { return acceleration_[3 * k + d]; });
      }
    if (now_.scene.effects.is_on(model::Effect::misalignment))
      add("position_z", [&frames](const unsigned int k) { return frames[k].position[2]; });
    if (std::all_of(now_.roller_bodies.begin(),
                    now_.roller_bodies.end(),
                    [this](const unsigned int k) { return turns(now_.scene.bodies[k]); }))
      add("spin", [this, &frames](const unsigned int k) {
        return now_.system.world.is_nodal(k) ? spin_of_nodes_[k] : frames[k].angular_velocity[2];
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
    dealii::Utilities::MPI::sum(spin_of_nodes_, world.communicator(), spin_of_nodes_);
  }

private:
  /// Whether @p roller has an angular velocity: a lumped one only where its ring turns.
  static bool turns(const scene::Body &roller)
  {
    return roller.motion != scene::Motion::lumped || roller.inertia[2] > 0.;
  }

  std::vector<double> acceleration_;  ///< of all bodies at the present sample
  std::vector<double> spin_of_nodes_; ///< of rollers that move by nodes, by body, rad/s
};

const Registered<Rollers> registered_rollers({"rollers", "How the rollers move.", {"shafts"}},
                                             parameters::QuantityGroup::roller_motion);
} // namespace
} // namespace chaindrive::observe
