// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/drift.h>
#include <chaindrive/observe/observation.h>

#include <deal.II/base/numbers.h>

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
  driven_speed,
  driver_torque,
  n_signals
};
} // namespace

Drift::Drift(const scene::Scene &scene, const unsigned int pitches_per_period)
{
  radius_     = scene.drive.driver().pitch_radius;
  pitch_time_ = 2. * dealii::numbers::PI / (scene.drive.driver().teeth * scene.loads.driver_speed);
  period_     = pitches_per_period * pitch_time_;
  begin(0.);
}

void Drift::begin(const double time)
{
  from_ = time;
  means_.assign(n_signals, WindowMean(from_, period_end()));
}

void Drift::add(const Observation &now)
{
  if (!now.system.world.is_first_rank() || now.time() <= from_)
    return;
  const scene::Sprocket &driver = now.scene.drive.driver(), &driven = now.scene.drive.driven();
  const double           first = now.time() - now.dt();
  const auto             take  = [&](const Signal signal, const double value) {
    means_[signal].add(first, now.dt(), value);
  };
  take(tight_tension, now.spans().tight().tension);
  take(slack_tension, now.spans().slack().tension);
  take(driven_speed, driven.sense * now.system.world.frames[driven.body].angular_velocity[2]);
  take(driver_torque, driver.sense * now.system.loads.torque(driver.body));
}

void Drift::next_period(const Observation &now)
{
  if (now.system.world.is_first_rank())
    {
      const auto   mean    = [this](const Signal signal) { return means_[signal].mean(); };
      const double tension = std::abs(mean(tight_tension)) + std::abs(mean(slack_tension));
      settling_.add(
          {mean(tight_tension) - mean(slack_tension), mean(driven_speed), mean(driver_torque)},
          {tension, 0.2 * std::abs(mean(driven_speed)), tension * radius_});
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
