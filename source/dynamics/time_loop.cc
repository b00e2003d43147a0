// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/time_loop.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::dynamics
{
unsigned long n_steps(const double start, const double end, const double dt)
{
  // a step that would miss the end by round-off only is not followed by another
  const double n = std::max(0., std::ceil((end - start) / dt - 1e-9));
  if (n > most_steps)
    throw InputError("The run would take " + to_text(n, 2) + " steps of " + to_text(dt * 1e6, 3) +
                     " us; at most " + to_text(most_steps) +
                     " are allowed: choose a larger Time/Time step in us or an earlier Time/End "
                     "time in ms.");
  return static_cast<unsigned long>(n);
}

unsigned long run(System                        &system,
                  const std::vector<Observer *> &observers,
                  const double                   start,
                  const double                   end,
                  const double                   dt,
                  unsigned long                  done)
{
  Services   services(system);
  const bool all_ask =
      std::all_of(observers.begin(), observers.end(), [](const Observer *observer) {
        return observer->asks_for_bodies();
      });
  const auto goes_on = [&](const unsigned long step, const double led_here) {
    for (Observer *observer : observers)
      observer->observe(system, step, led_here, services);
    return !services.stops();
  };
  const unsigned long last  = n_steps(start, end, dt);
  bool                going = done > 0 || goes_on(0, 0.);
  while (going && done < last)
    {
      ++done;
      if (all_ask)
        system.advance_without_update(dt, start + done * dt);
      else
        system.advance(dt, start + done * dt);
      going = goes_on(done, dt);
    }
  system.world.update_bodies();
  return done;
}
} // namespace chaindrive::dynamics
