// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/drift.h>
#include <chaindrive/observe/observation.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::observe
{
namespace
{
enum Signal : unsigned int
{
  tight_tension,
  slack_tension,
  driver_torque,
  first_speed ///< of the sprockets with a load, one after the other
};
} // namespace

Drift::Drift(const scene::Scene &scene, const unsigned int pitches_per_period)
{
  radius_ = scene.drive.driver().pitch_radius;
  for (const scene::Sprocket &sprocket : scene.drive.sprockets)
    if (sprocket.role == parameters::Role::driven)
      ++n_loads_;
  pitch_time_ = scene.pitch_time();
  period_     = pitches_per_period * pitch_time_;
  begin(0.);
}

void Drift::begin(const double time)
{
  from_ = time;
  means_.assign(first_speed + n_loads_, WindowMean(from_, period_end()));
}

void Drift::add(const Observation &now)
{
  if (!now.system.world.is_first_rank() || now.time() <= from_)
    return;
  const scene::Sprocket &driver     = now.scene.drive.driver();
  const double           first      = now.time() - now.dt();
  const auto             add_sample = [&](const unsigned int signal, const double value) {
    means_[signal].add(first, now.dt(), value);
  };
  add_sample(tight_tension, now.spans().tight().tension);
  add_sample(slack_tension, now.spans().slack().tension);
  add_sample(driver_torque, driver.sense * now.system.loads.torque(driver.body));
  unsigned int speed = first_speed;
  for (const scene::Sprocket &sprocket : now.scene.drive.sprockets)
    if (sprocket.role == parameters::Role::driven)
      add_sample(speed++,
                 sprocket.sense * now.system.world.frames[sprocket.body].angular_velocity[2]);
}

void Drift::next_period(const Observation &now)
{
  if (now.system.world.is_first_rank())
    {
      const auto   mean    = [this](const unsigned int signal) { return means_[signal].mean(); };
      const double tension = std::abs(mean(tight_tension)) + std::abs(mean(slack_tension));
      std::vector<double> means{mean(tight_tension) - mean(slack_tension), mean(driver_torque)},
          scales{tension, tension * radius_};
      for (unsigned int speed = first_speed; speed < means_.size(); ++speed)
        {
          means.push_back(mean(speed));
          scales.push_back(0.2 * std::abs(mean(speed)));
        }
      settling_.add(means, scales);
    }
  ++n_;
  begin(period_end());
  add(now); // the rest of this step
}

void Drift::serialize(const Archive &archive)
{
  archive("from", from_);
  archive("periods", n_);
  archive.numbers("means", means_);
  settling_.serialize(archive / "settling");
}
} // namespace chaindrive::observe
