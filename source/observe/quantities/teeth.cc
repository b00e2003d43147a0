// SPDX-License-Identifier: LGPL-2.1-or-later
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

  static bool exists(const Observation &start) { return !start.scene.teeth.empty(); }

  void add_channels(Channels &channels) override
  {
    const unsigned int n = now_.scene.n_joints;
    for (const ToothForces &forces : sprockets_)
      {
        const auto add = [&](const std::string    &group,
                             const std::string    &name,
                             const std::string    &description,
                             const unsigned int    columns,
                             const Channels::Fill &fill,
                             const std::string    &unit = "N") {
          channels.add(
              {group, forces.name + name, unit, description, columns, labels_up_to(columns)}, fill);
        };
        const unsigned int gaps = static_cast<unsigned int>(forces.in_gap.size());
        add("rollers",
            "_force",
            "Normal force of the " + forces.name + "'s teeth on the roller",
            n,
            copy_of(forces.roller));
        add("rollers",
            "_force_peak",
            "Its largest value since the last sample",
            n,
            copy_of(forces.roller_peak));
        add("rollers",
            "_gap",
            "Gap to the " + forces.name + "'s teeth, negative: overlap; NaN out of reach",
            n,
            smallest_gaps_of(forces.families),
            "m");
        add("teeth",
            "_force",
            "Normal force in each gap between two teeth",
            gaps,
            copy_of(forces.in_gap));
        add("teeth",
            "_force_peak",
            "Its largest value since the last sample",
            gaps,
            copy_of(forces.in_gap_peak));
      }
  }

  void update() override
  {
    for (ToothForces &forces : sprockets_)
      forces.look();
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
      summary["overlap_max"]["roller-" + forces.name] = forces.overlap;
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
        part("overlap", forces.overlap);
      }
  }

private:
  std::vector<ToothForces> sprockets_;
};

const Registered<Teeth> registered_teeth("teeth", 50, parameters::QuantityGroup::tooth_forces);
} // namespace
} // namespace chaindrive::observe
