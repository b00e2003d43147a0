// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/design_life.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/observe/old_names.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/schema.h>
#include <chaindrive/parameters/old_names.h>

namespace chaindrive::observe
{
namespace
{
/// Members of the summary that no quantity writes.
std::vector<files::Described> members_of_every_run()
{
  return {{"energy_turned_over",
           "J",
           "half of the sum of the magnitudes of all terms of the energy balance, largest"},
          {"energy_imbalance_max", "1", "error of the energy balance, largest"},
          {"momentum_imbalance_max", "1", "error of the balance of momentum, largest"},
          {"energy_jump_max", "1", "jump of the energy balance in 16 steps, largest"},
          {"checks/*/name", "", "design check that warns"},
          {"checks/*/severity", "", "warning"},
          {"checks/*/sentence", "", "what it says"},
          {"critical_time_step", "s", "critical time step"},
          {"time_step", "s", "time step"},
          {"steps", "1", "time steps"},
          {"window/start", "s", "begin of the window of the means"},
          {"window/end", "s", "end of the window of the means"},
          {"window/settled", "", "whether a window that waits for the drive to settle has begun"},
          {"window/judged_pitches", "1", "pitch times over which settling is judged"},
          {"window/valid", "", "whether no event lies in the window"},
          {"until/*/wanted", "1", "uncertainty over the mean that Output/Until asks for"},
          {"until/*/uncertainty", "1", "the one over the window"},
          {"until/*/reached", "", "whether that is enough"},
          {"accuracy/*/error",
           "1",
           "error of the output of this name in this model, as chaindrive calibrate has found it"},
          {"accuracy/*/low", "1", "lower end of its 95 % confidence interval"},
          {"accuracy/*/high", "1", "upper end"},
          {"plugins/*/name", "", "plug-in that was loaded; no member without any"},
          {"plugins/*/version", "", "its version"},
          {"plugins/*/path", "", "its shared library"},
          {"plugins/*/checksum", "", "of that file"},
          {"ranks", "1", "MPI ranks"},
          {"memory_peak", "B", "memory of all ranks, largest"},
          {"wall_seconds", "s", "elapsed time"},
          {"cpu_seconds/*", "s", "CPU time of all ranks in a phase, and in all together: total"}};
}

void add(files::Json                         &list,
         const std::vector<files::Described> &described,
         const std::string                   &quantities)
{
  for (const files::Described &one : described)
    {
      files::Json &entry = list[one.path];
      if (entry.is_null())
        entry = {{"unit", one.unit}, {"description", one.meaning}};
      if (!quantities.empty()) // some members are of several
        entry["quantities"].push_back(quantities);
    }
}

/// Each present name by the old one, of entries, of the values of entries by their path, and of
/// members of the summary.
files::Json old_names()
{
  files::Json entries = files::Json::object(), values = files::Json::object(),
              summary = files::Json::object();
  for (const parameters::OldEntry &one : parameters::old_entries())
    entries[one.old_path] = one.path;
  for (const parameters::OldValue &one : parameters::old_values())
    values[one.path][one.old_value] = one.value;
  for (const auto &[old_path, path] : old_members())
    summary[old_path] = path;
  return {{"entries", entries}, {"values", values}, {"summary", summary}};
}
} // namespace

files::Json schema()
{
  files::Json histories = files::Json::object(), summary = files::Json::object();
  histories["time"] = {{"unit", "s"}, {"description", "Time of each sample"}};
  for (const auto &[group, contents] : all_contents())
    {
      const std::string word = group ? text_of(*group) : "";
      add(histories, contents.histories, word);
      add(summary, contents.summary, word);
    }
  add(summary, members_of_every_run(), "");
  add(summary, drive::described_facts(), "");
  add(summary, drive::described_life(), "");
  return {{"histories", histories}, {"old_names", old_names()}, {"summary", summary}};
}
} // namespace chaindrive::observe
