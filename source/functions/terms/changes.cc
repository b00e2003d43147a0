// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/functions/terms.h>
#include <chaindrive/parameters/loads.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

namespace chaindrive::functions
{
namespace
{
using parameters::add;
namespace unit = parameters::unit;

/// Other speeds later in the run: the shaft stops, starts again, turns back.
struct Changes
{
  struct Parameters
  {
    std::vector<double>   times, durations, speeds; ///< s, s, rad/s
    parameters::SpeedRamp course = parameters::SpeedRamp::cosine;

    bool is_active() const { return !times.empty() || !durations.empty() || !speeds.empty(); }

    void declare(parameters::Declarations &declarations)
    {
      add(declarations,
          "Times in ms",
          times,
          unit::milli,
          parameters::between(0., 1e9),
          "When the speed of the driver begins to change, after the start and after its run-up. "
          "Empty: it does not.");
      add(declarations,
          "Durations in ms",
          durations,
          unit::milli,
          parameters::between(1e-3, 1e9),
          "How long each of these changes takes; it ends before the next one begins. An emergency "
          "stop takes some 100 ms.");
      add(declarations,
          "Speeds in rad/s",
          speeds,
          unit::si,
          parameters::between(-1e5, 1e5),
          "Speed after each of them: 0 is a stop, below zero the driver turns back.");
      add(declarations,
          "Course",
          course,
          "How the speed changes. linear: constant acceleration, which begins and ends with a "
          "jerk. cosine: half a cosine wave.");
    }
  };

  static Term make(const Parameters &given, const Shaft &shaft)
  {
    for (const auto &[entry, n] :
         {std::pair<const char *, std::size_t>{"Durations in ms", given.durations.size()},
          {"Speeds in rad/s", given.speeds.size()}})
      if (n != given.times.size())
        throw InputError(shaft.section + "/" + entry + " has " + std::to_string(n) +
                         " values, but Times in ms has " + std::to_string(given.times.size()) +
                         "; give one for each time.");
    const auto           ms = [](const double time) { return to_text(1e3 * time, 7) + " ms"; };
    std::vector<Pointer> changes;
    double               speed = shaft.speed, free_from = shaft.run_up;
    for (std::size_t i = 0; i < given.times.size(); ++i)
      {
        const double from = shaft.start + given.times[i];
        if (from < free_from)
          throw InputError(shaft.section + "/Times in ms: the change at " + ms(given.times[i]) +
                           " begins before the " + (i == 0 ? "run-up" : "one before it") +
                           " is over, at " + ms(free_from - shaft.start) +
                           "; choose a later time.");
        changes.push_back(std::make_shared<Ramp>(
            given.speeds[i] - speed,
            from,
            given.durations[i],
            given.course == parameters::SpeedRamp::cosine ? Rise::cosine : Rise::linear));
        speed     = given.speeds[i];
        free_from = from + given.durations[i];
      }
    return {Variable::time, std::make_shared<Sum>(changes)};
  }
};

const TermOf<Changes> changes_of_speed(Of::speed, {"Changes", "Other speeds later in the run."});
} // namespace
} // namespace chaindrive::functions
