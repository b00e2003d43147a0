// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/drift.h>
#include <chaindrive/observe/quantity.h>

#include <algorithm>

// Whether the drive had settled in the window of the averages.

namespace chaindrive::observe
{
namespace
{
class Settled : public Quantity
{
public:
  explicit Settled(const Observation &now)
      : Quantity(now), drift_(now.scene, now.window().pitches_per_period())
  {
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start)
  {
    return !start.scene.drive.sprockets.empty() && start.scene.drive.n_joints > 0 &&
           start.scene.loads.driver_speed > 0.;
  }

  static Contents contents()
  {
    return {{},
            {{"statistics/settled", "", "whether the drive had settled at the end of the window"}}};
  }

  void update() override
  {
    const Window &window = now_.window();
    if (window.waits()) // it has decided
      return;
    if (!begun_ && now_.time() > window.start())
      {
        drift_.begin(std::max(window.start(), now_.scene.start_time));
        begun_ = true;
      }
    if (!begun_)
      return;
    drift_.add(now_);
    // a last period may end with the window but for round-off
    while (now_.time() >= drift_.period_end() &&
           drift_.period_end() <= window.end() + 1e-6 * drift_.pitch_time())
      drift_.next_period(now_);
  }

  void summarize(files::Json &summary) const override
  {
    summary["statistics"]["settled"] = nullptr;
    if (now_.window().waits())
      summary["statistics"]["settled"] = now_.window().settled();
    else if (drift_.n_periods() >= Settling::n_periods)
      summary["statistics"]["settled"] = drift_.settled();
  }

  void serialize(const Archive &archive) override
  {
    archive("begun", begun_);
    drift_.serialize(archive / "drift");
  }

private:
  Drift drift_; ///< from the begin of the window on
  bool  begun_ = false;
};

const Registered<Settled> registered_settled(
    {"settled", "Whether the drive had settled in the window of the means.", {"spans"}},
    parameters::QuantityGroup::tensions);
} // namespace
} // namespace chaindrive::observe
