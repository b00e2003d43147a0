// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/until.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace chaindrive::observe
{
namespace
{
/// A mean over the window with its uncertainty, and of how many values it is.
struct Known
{
  double mean, uncertainty;
  double number; ///< tooth periods, or impacts
};

/// Impacts on a sprocket as they are called in names of means, and in the summary.
constexpr std::array<std::pair<const char *, const char *>, 3> of_impacts = {
    {{"_peak_mean", "peak_force"},
     {"_impulse_mean", "impulse"},
     {"_normal_speed_mean", "normal_speed"}}};

double number_in(const files::Json &member)
{
  return member.is_number() ? member.get<double>() : std::nan("");
}

/// All means of @p summary by name.
std::vector<std::pair<std::string, Known>> known_means(const files::Json &summary)
{
  std::vector<std::pair<std::string, Known>> known;
  if (summary.contains("statistics"))
    for (const auto &[name, found] : summary["statistics"].items())
      if (found.is_object())
        known.push_back({name + "_mean",
                         {number_in(found["mean"]),
                          number_in(found["uncertainty"]),
                          number_in(summary["statistics"]["tooth_periods"])}});
  if (summary.contains("spans") && summary.contains("statistics"))
    for (const auto &[span, found] : summary["spans"].items())
      for (const char *what : {"_tension", "_speed"})
        known.push_back({span + what + "_mean",
                         {number_in(found[std::string(what + 1) + "_mean"]),
                          number_in(found[std::string(what + 1) + "_uncertainty"]),
                          number_in(summary["statistics"]["tooth_periods"])}});
  if (summary.contains("impacts"))
    for (const auto &[sprocket, found] : summary["impacts"].items())
      for (const auto &[ending, member] : of_impacts)
        known.push_back({sprocket + ending,
                         {number_in(found[member]["mean"]),
                          number_in(found[member]["uncertainty"]),
                          number_in(found["number"])}});
  return known;
}

std::optional<Known> find(const files::Json &summary, const std::string &output)
{
  for (const auto &[name, known] : known_means(summary))
    if (name == output)
      return known;
  return {};
}
} // namespace

Until::Until(const std::vector<parameters::Wanted> &wanted,
             const files::Json                     &start,
             const unsigned int                     pitches_per_period)
    : wanted_(wanted), fewest_(8 * pitches_per_period)
{
  for (const parameters::Wanted &one : wanted)
    if (!find(start, one.output))
      {
        std::vector<std::string> names;
        for (const auto &[name, known] : known_means(start))
          names.push_back(name);
        throw InputError("Output/Until: this run has no mean '" + one.output + "'. " +
                         (names.empty() ?
                              "It has none: Output/Quantities ask for none." :
                              "It has: " + join(names) + "; Output/Quantities choose them."));
      }
}

void Until::summarize(files::Json &summary) const
{
  for (const parameters::Wanted &one : wanted_)
    {
      const Known  known = *find(summary, one.output);
      const double found =
          known.number >= fewest_ ? known.uncertainty / std::abs(known.mean) : std::nan("");
      summary["until"][one.output] = {{"wanted", one.uncertainty},
                                      {"uncertainty", found},
                                      {"reached", found <= one.uncertainty}};
    }
}

bool Until::is_reached(const files::Json &summary)
{
  const auto &all = summary["until"];
  return std::all_of(
      all.begin(), all.end(), [](const files::Json &one) { return one["reached"].get<bool>(); });
}

std::string until_sentence(const files::Json &summary, const double time)
{
  if (!summary.contains("until"))
    return "";
  std::vector<std::string> known, unknown;
  double                   longest = 0.; // windows like this one that it takes
  for (const auto &[name, one] : summary["until"].items())
    {
      const double      wanted = one["wanted"].get<double>(), found = number_in(one["uncertainty"]);
      const std::string text =
          name + " to " + (std::isfinite(found) ? to_text(100. * found, 2) + " %" : "nothing") +
          " (" + to_text(100. * wanted, 2) + " %)";
      (one["reached"].get<bool>() ? known : unknown).push_back(text);
      if (std::isfinite(found))
        longest = std::max(longest, (found / wanted) * (found / wanted));
    }
  if (unknown.empty())
    return "After " + to_text(1e3 * time, 5) +
           " ms the run knows what Output/Until asks for: " + join(known) + ".";
  const double from = number_in(summary["window"]["start"]),
               to   = number_in(summary["window"]["end"]);
  return "At its end, after " + to_text(1e3 * time, 5) +
         " ms, the run does not know what Output/Until asks for: " + join(unknown) +
         (known.empty() ? "" : "; but " + join(known)) + "." +
         (longest > 1. && std::isfinite(to - from) ?
              " The uncertainty falls with the root of the time: Time/End time in ms = " +
                  to_text(1e3 * (from + longest * (to - from)), 2) + " may be enough." :
              " A window of at least eight periods of the drive's slowest resonance is needed: run "
              "longer.");
}
} // namespace chaindrive::observe
