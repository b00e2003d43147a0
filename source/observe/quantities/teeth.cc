// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>
#include <chaindrive/observe/tooth_forces.h>

#include <algorithm>

// What the teeth do to the rollers, by roller and by gap between two teeth.

namespace chaindrive::observe
{
namespace
{
class Teeth : public Quantity
{
public:
  explicit Teeth(const Observation &now)
      : Quantity(now), sprockets_(make_tooth_forces(now.scene, now.system))
  {
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.teeth.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const std::string &name : known_sprockets())
      {
        for (const files::Described &history : histories_of(name))
          contents.histories.push_back(history);
        if (name == any_sprocket)
          continue; // members of the summary are described by name
        contents.summary.push_back({"penetration_max/" + scene::name_of_teeth(name),
                                    "m",
                                    "penetration of the two sides, largest"});
        contents.summary.push_back({"contact_pressure_max/" + scene::name_of_teeth(name),
                                    "Pa",
                                    "largest contact pressure at samples in the window, of "
                                    "elastic rollers"});
      }
    return contents;
  }

  void add_channels(Channels &channels) override
  {
    const unsigned int n = now_.scene.drive.n_joints;
    for (const ToothForces &forces : sprockets_)
      {
        const std::vector<std::string> joints = labels_up_to(n),
                                       gaps   = labels_up_to(
                                           static_cast<unsigned int>(forces.in_gap.size()));
        const auto histories = histories_of(forces.name);
        channels.add(histories[0], joints, copy_of(forces.roller));
        channels.add(histories[1], joints, copy_of(forces.roller_peak));
        channels.add(histories[2], joints, smallest_gaps_of(forces.families));
        if (!forces.flat)
          {
            channels.add(histories[3], gaps, copy_of(forces.in_gap));
            channels.add(histories[4], gaps, copy_of(forces.in_gap_peak));
          }
        if (know_pressure(forces.families))
          channels.add(histories[5], joints, copy_of(forces.pressure));
      }
  }

  void update() override
  {
    for (ToothForces &forces : sprockets_)
      forces.update();
  }

  void gather() override
  {
    for (ToothForces &forces : sprockets_)
      find_pressures(now_, forces.families, forces.pressure, forces.pressure_max);
  }

  void begin_interval() override
  {
    for (ToothForces &forces : sprockets_)
      for (auto *peaks : {&forces.roller_peak, &forces.in_gap_peak})
        std::fill(peaks->begin(), peaks->end(), 0.);
  }

  void summarize(files::Json &summary) const override
  {
    for (const ToothForces &forces : sprockets_)
      {
        summary["penetration_max"][scene::name_of_teeth(forces.name)] = forces.penetration;
        if (know_pressure(forces.families))
          summary["contact_pressure_max"][scene::name_of_teeth(forces.name)] = forces.pressure_max;
      }
  }

  void serialize(const Archive &archive) override
  {
    for (ToothForces &forces : sprockets_)
      {
        const Archive part = archive / forces.name;
        part.numbers("roller", forces.roller);
        part.numbers("roller peak", forces.roller_peak);
        part.numbers("gap", forces.in_gap);
        part.numbers("gap peak", forces.in_gap_peak);
        part("overlap", forces.penetration);
        part("pressure", forces.pressure_max);
        forces.replace_all();
      }
  }

private:
  /// Of one sprocket.
  static std::vector<files::Described> histories_of(const std::string &name)
  {
    const std::string rollers = "rollers/" + name, teeth = "teeth/" + name,
                      peak = "Its largest value since the last sample";
    return {{rollers + "_force", "N", "Normal force of the " + name + "'s teeth on the roller"},
            {rollers + "_force_peak", "N", peak},
            {rollers + "_gap",
             "m",
             "Gap to the " + name + "'s teeth, negative: penetration; NaN out of reach"},
            {teeth + "_force", "N", "Normal force in each gap between two teeth"},
            {teeth + "_force_peak", "N", peak},
            {rollers + "_pressure",
             "Pa",
             "Largest contact pressure of the " + name + "'s teeth on an elastic roller"}};
  }

  std::vector<ToothForces> sprockets_;
};

const Registered<Teeth> registered_teeth({"teeth", "The forces on the teeth.", {"settled"}},
                                         parameters::QuantityGroup::tooth_forces);
} // namespace
} // namespace chaindrive::observe
