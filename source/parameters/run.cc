// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/run.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <optional>

namespace chaindrive::parameters
{
namespace
{
/// "driver_peak_mean=2, tight_tension_mean=0.5", in percent; empty if it is not understood, or
/// names a mean twice.
std::optional<std::vector<Wanted>> read_wanted(const std::string &text)
{
  std::vector<Wanted> all;
  for (const std::string &word : dealii::Utilities::split_string_list(text, ','))
    {
      const std::size_t           equals  = std::min(word.find('='), word.size());
      const std::string           output  = dealii::Utilities::trim(word.substr(0, equals));
      const std::optional<double> percent = from_entry_text(
          dealii::Utilities::trim(word.substr(std::min(equals + 1, word.size()))), unit::percent);
      if (output.empty() || !percent || !(*percent > 0. && *percent <= 1.) ||
          std::any_of(all.begin(), all.end(), [&output](const Wanted &one) {
            return one.output == output;
          }))
        return {};
      all.push_back({output, *percent});
    }
  return all;
}
} // namespace

bool Output::names(const QuantityGroup group) const
{
  return std::find(quantities.begin(), quantities.end(), group) != quantities.end();
}

void Time::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Time");
  add(declarations,
      "Start time in ms",
      start,
      unit::milli,
      between(0., 1e9),
      "Time at which the run begins. It only shifts the time axis of the results: the ramps begin "
      "with the run.");
  add(declarations,
      "End time in ms",
      end,
      unit::milli,
      above(0., 1e9),
      "Time at which the run ends. Speeds and tensions need about ten pitch times after the "
      "start-up transient. Default: as in prm/paper, nearly nine pitch times.")
      .on_resume = OnResume::must_stay_with_region_of_interest;
  add(declarations,
      "Time step in us",
      step,
      unit::micro,
      above(0., 1e6),
      "Time step. A time step above the critical one is refused, not shortened. auto: of rigid "
      "bodies a twelfth of the shortest period of vibration, of elastic ones the critical one "
      "times Safety factor.");
  add(declarations,
      "Safety factor",
      safety_factor,
      unit::si,
      above(0., 1.),
      "Largest accepted time step over the critical one, which holds for linear vibration. "
      "Default: leaves ten percent for nonlinearity.");
  add(declarations,
      "Energy limit in percent",
      energy_limit,
      unit::percent,
      above(0., 100.),
      "Energy imbalance, over the energy turned over, at which a run stops. A valid run stays "
      "below 0.1 (simple) or 0.5 (layered), in its first impacts below 3; a larger imbalance means "
      "that the time step is too large. Default: results are no longer valid beyond it.");
  add(declarations,
      "Guard",
      guard,
      "Whether a run also stops within 100 steps when momentum is not balanced, energy jumps, a "
      "loss or a stored energy is negative, or the penetration reaches a quarter of a radius; the "
      "message names the place. Default: it costs next to nothing.");
}

void Output::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Output", OnResume::may_change);
  add_text(declarations,
           "Directory",
           directory,
           "a directory name or nothing",
           "Directory of the results, relative to the one in which the program is started. "
           "Default: results/ and the name of the .prm file. The option --output overrides it.");
  add(declarations,
      "Quantities",
      quantities,
      "Requested results. The rest is not computed: it has no history, no member of the summary "
      "and costs nothing; an effect that is auto is off unless a requested quantity needs it (see "
      "the table at the end). all: everything that the fidelity has.")
      .on_resume = OnResume::must_stay;
  add(declarations,
      "History interval in us",
      history_interval,
      unit::micro,
      above(0., 1e9),
      "Time between two samples of the histories. The maximum of every force since the last sample "
      "is also recorded, since an impact may last only 20 us. Below the time step, every step is a "
      "sample.");
  add(declarations,
      "History precision",
      precision,
      "Precision of the stored histories of single rollers, links, joints and teeth: single, with "
      "seven digits, takes half of the space, and even less when they are compressed at the end of "
      "the run; double keeps all digits. Everything else, and all computation, is in double "
      "precision.")
      .on_resume = OnResume::must_stay;
  add(declarations,
      "Field interval in ms",
      field_interval,
      unit::milli,
      between(0., 1e9),
      "Time between two field outputs of all bodies for ParaView; 0 writes none. Only if "
      "Quantities is all or includes fields. auto: a tenth of the driver's pitch time, so that an "
      "animation runs forward and rollers can be followed.");
  add(declarations,
      "Rollers",
      rollers,
      "Numbers of the rollers whose motion is recorded in the histories. Roller 0 sits on the "
      "driver where the tight span arrives; numbers grow in the direction of travel.")
      .on_resume = OnResume::must_stay;
  add(declarations,
      "CSV",
      csv,
      "Whether the histories are also written as CSV files, in addition to HDF5.");
  add(declarations,
      "Window start in ms",
      window_start,
      unit::milli,
      between(0., 1e9),
      "Start of the evaluation window, over which summary.json averages; choose it after the "
      "start-up transient. settled: when the pitch-time means of tension, driven speed and driver "
      "torque have stopped drifting (doc/theory.md); the run ends when the window is full, at End "
      "time at the latest. Default: the drive in prm/paper has settled by then.",
      "settled")
      .on_resume = OnResume::must_stay_with_region_of_interest;
  add(declarations,
      "Window end in ms",
      window_end,
      unit::milli,
      above(0., 1e9),
      "End of that window. auto: the end of the run.")
      .on_resume = OnResume::must_stay_with_region_of_interest;
  add(declarations,
      "Window length in pitches",
      window_pitches,
      1,
      1000000,
      "Length, in whole pitch times of the driver, of a window that begins when the drive has "
      "settled. If the driven inertia on the tight span vibrates more slowly than the tooth "
      "frequency, it is at least six of its periods.");
  declarations.add(
      "Until",
      "",
      "names of means, each with its number of percent up to 100, such as driver_peak_mean=2, "
      "separated by commas, or nothing",
      "The run ends when these means of the window are known so well: when half of the 95 % "
      "confidence interval of each (doc/output.md) is at most so many percent of it, and the "
      "window contains at least eight periods of the drive's slowest resonance; at End time at "
      "the latest. Possible are the signals of `statistics`, such as tight_tension_mean, and of "
      "`impacts`, such as driver_peak_mean, driven_impulse_mean and driver_normal_speed_mean. "
      "Default: the run ends at End time, or when a window that waits is full.",
      [](const std::string &text) { return read_wanted(text).has_value(); },
      [this](const std::string &text) { until = *read_wanted(text); });
  add(declarations,
      "Checkpoint interval in ms",
      checkpoint_interval,
      unit::milli,
      between(0., 1e9),
      "Simulated time between two checkpoints, from which an interrupted run, or one with a later "
      "end time, can resume; 0 writes none for this reason. Two are kept.");
  add(declarations,
      "Checkpoint wait in s",
      checkpoint_wait,
      unit::si,
      between(0., 1e9),
      "Elapsed time after which a checkpoint is also written; 0 writes none for this reason. "
      "Default: no interruption costs more than ten minutes, and short runs write none.");
  add(declarations,
      "Wall-clock limit in s",
      wall_clock_limit,
      unit::si,
      between(0., 1e9),
      "Elapsed time after which the run writes a checkpoint and ends with status 4, as on SIGTERM; "
      "0 sets no limit. Choose some minutes less than the queue allows.");
  add_text(declarations,
           "Resume",
           resume,
           "auto, the name of a checkpoint, or nothing",
           "Checkpoint in the output directory from which to resume: auto is the newest intact "
           "one, or the beginning if there is none. The option --resume overrides it.");
}
} // namespace chaindrive::parameters
