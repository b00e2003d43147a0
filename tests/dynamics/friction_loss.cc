// SPDX-License-Identifier: LGPL-2.1-or-later
// What friction has eaten it does not give back: a point dragged to and fro under a changing load,
// and drives, with friction up to 2 and tangential springs down to a thousandth of the normal ones.
#include "../support/faults.h"
#include "../support/scenes.h"

#include <chaindrive/contact/point_force.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>

using namespace test;

namespace
{
/// The loss and by how much it has been less than it was before.
struct Watch
{
  double largest = 0., fall = 0.;
  double bound = 0., imbalance = 0.;

  void update(const double loss)
  {
    largest = std::max(largest, loss);
    fall    = std::max(fall, largest - loss);
  }
};

Watch drag(const double friction, const double ratio)
{
  const double            k = 2e8, m = 0.01, c = 0.2 * std::sqrt(k * m), dt = 2.5e-7;
  const scene::ContactLaw law{k, c, friction, ratio * k, ratio * c};
  contact::TouchState     state;
  Ledger                  ledger;
  Watch                   watch;
  for (unsigned int n = 0; n < 40000; ++n)
    {
      const double t     = n * dt;
      const double depth = 5e-6 * (1. + 0.9 * std::sin(6e3 * t)),
                   rate  = -5e-6 * 0.9 * 6e3 * std::cos(6e3 * t);
      dealii::Tensor<1, 2> slip;
      slip[0] = 1.5 * std::sin(2.3e3 * t) + 0.2 * std::sin(4e4 * t);
      slip[1] = 0.7 * std::cos(3.1e3 * t);
      ledger.clear_stored();
      contact::update_point(law, -depth, rate, slip, dt, state, ledger);
      watch.update(ledger.friction);
      watch.bound += friction * state.normal * slip.norm() * dt;
    }
  return watch;
}

/// What the drive of hard.prm loses in @p time [s] with steps that are @p part of the stable one.
Watch run(const std::vector<std::string> &overrides, const double part, const double time)
{
  dynamics::System system(drive_scene("prm/verification/hard.prm", overrides), false);
  const double     dt = part * system.critical_time_step();
  Watch            watch;
  double           worst = 0.;
  advance(system, static_cast<unsigned long>(time / dt), dt, [&]() {
    watch.update(system.world.ledger.friction);
    worst = std::max(worst, std::abs(system.world.ledger.imbalance()));
  });
  watch.imbalance = worst / system.world.ledger.drive_work;
  return watch;
}

void judge(const std::string &what, const Watch &watch)
{
  std::cout << what << ": " << (watch.fall <= 1e-9 * watch.largest ? "never" : "FALLS") << '\n';
}
} // namespace

int main()
{
  std::cout << "does the loss fall?\n";
  for (const double friction : {0.1, 1., 2.})
    for (const double ratio : {1e-3, 1e-2, 0.1})
      {
        const std::string law =
            "friction " + to_text(friction) + ", ratio " + to_text(ratio) + ", ";
        const Watch point = drag(friction, ratio);
        judge(law + "point", point);
        verdict("  no more than the limit times the path", point.largest < point.bound);
        for (const std::string stiffness : {"auto", "1e9"})
          {
            const Watch drive = run({"Contact/Friction coefficient=" + to_text(friction),
                                     "Contact/Tangential ratio=" + to_text(ratio),
                                     "Model/Stiffness per pitch in N/m=" + stiffness},
                                    0.2,
                                    3e-3);
            judge(law + "simple drive, bars " + stiffness, drive);
            if (drive.imbalance > 1e-3)
              std::cout << "  imbalance " << drive.imbalance << " of the drive work\n";
          }
      }
  judge("layered drive", run({"Model/Fidelity=layered"}, 0.3, 5e-4));
}
