// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/time_loop.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::dynamics
{
void EnergyGuard::check(const Ledger &ledger, const double time)
{
  const double imbalance = std::abs(ledger.imbalance());
  turned_over_           = std::max({turned_over_, std::abs(ledger.drive_work), ledger.stored()});
  largest_               = std::max(largest_, imbalance);
  if (!(imbalance <= limit_ * turned_over_)) // also true when it is not a number
    throw RunError("The energy balance does not close at " + to_text(time * 1e3) +
                   " ms: imbalance " + to_text(ledger.imbalance()) + " J of " +
                   to_text(turned_over_) + " J turned over, more than the accepted " +
                   to_text(limit_ * 100.) +
                   " % (Time/Energy limit in percent). Histories up to this moment are complete.");
}

unsigned long n_steps(const double start, const double end, const double dt)
{
  // a step that would miss the end by round-off only is not followed by another
  return static_cast<unsigned long>(std::max(0., std::ceil((end - start) / dt - 1e-9)));
}

unsigned long run(System       &system,
                  Observer     &observer,
                  EnergyGuard  &guard,
                  const double  start,
                  const double  end,
                  const double  dt,
                  unsigned long done)
{
  const unsigned long last  = n_steps(start, end, dt);
  bool                going = done > 0 || observer.observe(system, 0, 0.);
  while (going && done < last)
    {
      ++done;
      system.advance(dt, start + done * dt);
      guard.check(system.world.ledger, system.world.time);
      going = observer.observe(system, done, dt);
    }
  return done;
}
} // namespace chaindrive::dynamics
