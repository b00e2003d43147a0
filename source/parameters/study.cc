// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/study.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>

namespace chaindrive::parameters
{
namespace
{
/// The words of a list, without empty ones.
std::vector<std::string> split(const std::string &text, const char separator)
{
  std::vector<std::string> words = dealii::Utilities::split_string_list(text, separator);
  words.erase(std::remove(words.begin(), words.end(), ""), words.end());
  return words;
}

void add_list(Declarations                                                &declarations,
              const std::string                                           &name,
              std::vector<std::string>                                    &member,
              const char                                                   separator,
              const std::function<bool(const std::vector<std::string> &)> &accepts,
              const std::string                                           &allowed,
              const std::string                                           &meaning)
{
  declarations.add(
      name,
      join(member, std::string(1, separator) + " "),
      allowed,
      meaning,
      [=](const std::string &text) { return accepts(split(text, separator)); },
      [&member, separator](const std::string &text) { member = split(text, separator); });
}

/// Letters that any file system and shell takes. A hyphen in front would begin an option, a dot a
/// folder of Snakemake's.
bool is_name(const std::string &text)
{
  return !text.empty() && text.front() != '-' && text.front() != '.' &&
         std::all_of(text.begin(), text.end(), [](const unsigned char c) {
           return std::isalnum(c) ||
                  std::string("-_.=+,").find(static_cast<char>(c)) != std::string::npos;
         });
}

constexpr std::size_t longest_name = 200; ///< file systems take 255

/// Whether a folder of this name would stand where the study has a file of its own
/// (study_command.cc and scripts/study write them), or may do so in later versions.
bool is_own_file(const std::string &name)
{
  for (const std::string stem : {"study.", "table.", "chart.", "chart-orders."})
    if (name.compare(0, stem.size(), stem) == 0)
      return true;
  return false;
}

std::string did_you_mean(const std::string &name, const std::vector<std::string> &candidates)
{
  if (const std::string nearest = nearest_name(name, candidates); !nearest.empty())
    return " Did you mean '" + nearest + "'?";
  const std::vector<std::string> begun = names_begun_with(name, candidates); // "tight_tension"
  if (begun.empty())
    return " There are: " + join(candidates) + ".";
  return (begun.size() == 1 ? " Did you mean '" : " Did you mean one of '") + join(begun, "', '") +
         "'?";
}

bool contains(const std::vector<std::string> &words, const std::string &word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}
} // namespace

const std::vector<StudyOutput> &study_outputs()
{
  static const std::vector<StudyOutput> all = {
      {"driven_speed_mean",
       "rad/s",
       "of summary.json, as all up to `energy_imbalance_max`",
       {QuantityGroup::speeds}},
      {"span_speed_mean", "m/s", "", {QuantityGroup::tensions}},
      {"pitch_time_mean", "s", "", {QuantityGroup::engagements}},
      {"tight_tension_mean", "N", "", {QuantityGroup::tensions}},
      {"slack_tension_mean", "N", "", {QuantityGroup::tensions}},
      {"tight_tension_max_start", "N", "", {QuantityGroup::tensions}},
      {"driver_torque_mean", "N m", "", {QuantityGroup::speeds}},
      {"drive_work", "J", "", {QuantityGroup::energy}},
      {"resisting_work", "J", "", {QuantityGroup::energy}},
      {"energy_imbalance_max", "1", "", {QuantityGroup::energy}},
      {"tension_difference_mean", "N", "tight less slack tension", {QuantityGroup::tensions}},
      {"losses", "J", "of friction and damping together, whole run", {QuantityGroup::energy}},
      {"driver_peak_mean",
       "N",
       "mean peak force of the rollers that engage with the driver in the window",
       {QuantityGroup::engagements}},
      {"driver_peak_max", "N", "the largest of these peaks", {QuantityGroup::engagements}},
      {"driver_peak_cv",
       "1",
       "their standard deviation over their mean: variation between rollers",
       {QuantityGroup::engagements}},
      {"driver_peak_max_over_min",
       "1",
       "the largest of them over the smallest",
       {QuantityGroup::engagements}},
      {"driver_impulse_mean",
       "N s",
       "mean impulse of these engagements",
       {QuantityGroup::engagements}},
      {"driver_impulse_cv",
       "1",
       "its standard deviation over its mean",
       {QuantityGroup::engagements}},
      {"driver_normal_speed_mean",
       "m/s",
       "mean speed at which they touch, along the normal of the contact",
       {QuantityGroup::engagements}},
      {"driven_peak_mean", "N", "the same for the driven sprocket", {QuantityGroup::engagements}},
      {"driven_peak_max", "N", "", {QuantityGroup::engagements}},
      {"driven_peak_cv", "1", "", {QuantityGroup::engagements}},
      {"driven_peak_max_over_min", "1", "", {QuantityGroup::engagements}},
      {"driven_impulse_mean", "N s", "", {QuantityGroup::engagements}},
      {"driven_impulse_cv", "1", "", {QuantityGroup::engagements}},
      {"tight_tension_ripple",
       "N",
       "standard deviation over time of the tight span's tension in the window",
       {QuantityGroup::tensions}},
      {"driven_speed_ripple",
       "rad/s",
       "the same of the driven hub's speed",
       {QuantityGroup::speeds}},
      {"roller_velocity_rms",
       "m/s",
       "r.m.s. velocity of a roller's centre above 710 Hz, both directions together, from one "
       "pitch time before it touches the driver to one after; mean over the rollers that engage in "
       "the window",
       {QuantityGroup::engagements, QuantityGroup::roller_motion}},
      {"roller_velocity_spectrum",
       "m/s",
       "the same in third octaves from 800 Hz to 20 kHz, a column for each below half of the "
       "sampling frequency",
       {QuantityGroup::engagements, QuantityGroup::roller_motion}},
      {"roller_velocity_variation",
       "1",
       "variation between these rollers: r.m.s. difference of their velocities, aligned at first "
       "contact, from the mean curve, over the r.m.s. of that",
       {QuantityGroup::engagements, QuantityGroup::roller_motion}},
      {"surface_velocity_rms",
       "m/s",
       "as roller_velocity_rms, of a node on the roller's surface; elastic rollers",
       {QuantityGroup::engagements, QuantityGroup::surface_velocity}},
      {"surface_velocity_variation",
       "1",
       "as roller_velocity_variation, of this node",
       {QuantityGroup::engagements, QuantityGroup::surface_velocity}},
      {"plate_stress_max",
       "Pa",
       "largest stress along a link at the waist of its plates, axial plus both bending stresses, "
       "over all links and samples of the window; elastic links",
       {QuantityGroup::plate_stress}},
      {"plate_bending_max",
       "Pa",
       "largest sum of both bending stresses; elastic links",
       {QuantityGroup::plate_stress}},
      {"loss_power_mean",
       "W",
       "dissipated energy of the whole run over its duration",
       {QuantityGroup::energy}},
      {"wear_rate",
       "1/s",
       "elongation of the chain per second by the friction work between pins and bushes in the "
       "window; against Drive/Chain/Elongation in percent the report adds up hours",
       {QuantityGroup::energy}},
      {"plate_safety",
       "1",
       "endurance of link plates over the largest cycle of tension in a turn of the chain",
       {QuantityGroup::tensions}},
      {"roller_life",
       "h",
       "until rollers or bushes fail, by the peaks of their impacts on the driver",
       {QuantityGroup::engagements}},
      {"sound_level",
       "dB",
       "at the first observer of acoustics.json, with Acoustics/Noise = on",
       {}},
      {"sound_level_a", "dB", "the same, A-weighted", {}},
      {"sound_spectrum", "dB", "the same, unweighted, in third octaves, a column for each", {}},
      {"sound_peak_cv",
       "1",
       "standard deviation over mean of the largest pressures there in each pitch time",
       {}}};
  return all;
}

std::string study_output_documentation()
{
  std::string text = "\nOutputs of a study:\n\n| Output | Unit | Meaning |\n|---|---|---|\n";
  for (const StudyOutput &output : study_outputs())
    text +=
        "| `" + std::string(output.name) + "` | " + output.unit + " | " + output.meaning + " |\n";
  return text;
}

void Study::check_outputs() const
{
  std::vector<std::string> all;
  for (const StudyOutput &output : study_outputs())
    all.emplace_back(output.name);
  for (const std::string &name : outputs)
    {
      if (!contains(all, name))
        throw InputError("Study/Outputs: there is no output '" + name + "'." +
                         did_you_mean(name, all));
      if (std::count(outputs.begin(), outputs.end(), name) > 1)
        throw InputError("Study/Outputs names '" + name + "' twice: name each output once.");
    }
}

void Study::check_quantities(const Output &output) const
{
  for (const StudyOutput &one : study_outputs())
    for (const QuantityGroup group : one.needs)
      if (contains(outputs, one.name) && !output.asks_for(group))
        throw InputError("Study/Outputs: '" + std::string(one.name) + "' is made of " +
                         text_of(group) + ", which Output/Quantities does not keep: add '" +
                         text_of(group) + "' there, or leave the output out.");
}

void Study::check_against(const std::vector<Variant> &variants) const
{
  if (against.empty())
    return;
  std::vector<std::string> loops;
  for (const Variant &variant : variants)
    for (const auto &[path, value] : variant.choices)
      {
        if (!contains(loops, path))
          loops.push_back(path);
        if (path == against && !from_entry_text(value, unit::si))
          throw InputError("Study/Against = " + against + " must have numbers, not '" + value +
                           "'.");
      }
  if (!contains(loops, against))
    throw InputError("Study/Against = " + against + " is no entry with a loop." +
                     (loops.empty() ? "" : did_you_mean(against, loops)));
}

void Study::name(std::vector<Variant> &variants)
{
  if (!names.empty() && names.size() != variants.size())
    throw InputError("Study/Names has " + std::to_string(names.size()) + " names for " +
                     std::to_string(variants.size()) + " variants.");
  for (std::size_t i = 0; i < names.size(); ++i)
    variants[i].name = names[i];
  names.clear();
  for (const Variant &variant : variants)
    {
      if (is_own_file(variant.name))
        throw InputError("No variant can be called '" + variant.name +
                         "': study.*, table.*, chart.* and chart-orders.* are files of the study. "
                         "Give it another name in Study/Names.");
      if (variant.name.size() > longest_name)
        throw InputError("The name '" + variant.name + "' has more than " +
                         std::to_string(longest_name) +
                         " letters, too many for a folder: give the variants names in "
                         "Study/Names.");
      if (contains(names, variant.name))
        throw InputError("There are two variants called '" + variant.name +
                         "': give each a name of its own in Study/Names, or leave one out.");
      names.push_back(variant.name);
    }
  if (reference.empty())
    reference = names.back();
  if (!contains(names, reference))
    throw InputError("Study/Reference = " + reference + " is no variant." +
                     did_you_mean(reference, names));
}

void Study::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Study");
  add_text(declarations,
           "Title",
           title,
           "any text or nothing",
           "Heading of the report. Default: the name of the file.");
  add_text(declarations,
           "Text",
           text,
           "any text or nothing",
           "The question that the study answers, in Markdown, below the heading.");
  add_list(
      declarations,
      "Names",
      names,
      ',',
      [](const auto &words) { return std::all_of(words.begin(), words.end(), is_name); },
      "names of letters, digits and -_.=+ that begin with none of -., separated by commas, or "
      "nothing",
      "Names of the variants, in the order of deal.II's MultipleParameterLoop, in which the loop "
      "of the entry that comes first in this list changes fastest. Default: the values that the "
      "loops give to each.");
  add_text(declarations,
           "Reference",
           reference,
           "the name of a variant or nothing",
           "The variant to which errors are relative. Default: the last.");
  add_list(
      declarations,
      "Outputs",
      outputs,
      ',',
      [](const auto &words) { return !words.empty(); },
      "names of the table of outputs below, separated by commas",
      "Results by which variants are compared.");
  add_text(declarations,
           "Against",
           against,
           "an entry whose loop has numbers, or nothing",
           "The report plots the outputs against this entry, with a curve for each combination of "
           "the others; against the driver's speed also the orders of tight-span tension and "
           "sound. Default: errors against CPU time.");
  add(declarations,
      "Phases",
      phases,
      1,
      1000,
      "Start phases from which each variant runs, evenly distributed over a tooth, the first as in "
      "Drive/Layout/Start phase. Results are means over them. Peaks of single rollers are chaotic "
      "and need at least 8.");
  add(declarations,
      "Ranks",
      ranks,
      1,
      1024,
      "MPI processes of each run. The only entry of this section that may be a loop. Default: many "
      "runs at a time use the cores better than many ranks.");
  add_list(
      declarations,
      "Quick",
      quick,
      ';',
      [](const auto &) { return true; },
      "Section/Entry=value, separated by semicolons, or nothing",
      "Changes made by the option --quick, so that the study takes minutes: a shorter run, fewer "
      "phases.");
}
} // namespace chaindrive::parameters
