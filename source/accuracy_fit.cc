// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/accuracy.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace chaindrive
{
namespace
{
/// What the model @p variant is.
std::vector<std::string> entries_of_model(const std::string &variant)
{
  if (variant == "oval")
    return {"Model/Fidelity=layered", "Effects/Oval rollers=on"};
  return {"Model/Fidelity=" + variant};
}
} // namespace

std::vector<StudyResult> predicted(const Studies                       &studies,
                                   const std::string                   &output,
                                   const std::map<std::string, double> &here)
{
  std::vector<StudyResult> results;
  for (const Fit &fit : studies.fits)
    {
      if (fit.output != output)
        continue;
      double off = 0.;
      if (fit.group != "-")
        {
          const auto group = here.find(fit.group);
          if (group == here.end() || !(group->second > 0.) || !std::isfinite(group->second))
            continue;
          off = std::log(group->second) - fit.x_mean;
        }
      const double middle = fit.centre + fit.slope * off,
                   half =
                       fit.factor * std::sqrt(1. + 1. / fit.n_drives +
                                              (fit.group == "-" ? 0. : off * off / fit.x_square));
      StudyResult result;
      result.study     = "prediction";
      result.variant   = fit.variant;
      result.reference = "exact";
      result.output    = output;
      result.error     = std::expm1(middle);
      result.low       = std::expm1(middle - half);
      result.high      = std::expm1(middle + half);
      result.overrides = entries_of_model(fit.variant);
      double of_pitch  = 0.; // sum of the squares of deviations in a window of a pitch
      for (const StudyResult &one : studies.results)
        if (one.variant == fit.variant && one.output == output)
          {
            result.cpu += one.cpu;
            result.reference_cpu += one.reference_cpu;
            if (const Scatter &its = one.scatter; its.deviation > 0. && its.degrees > 0.)
              {
                of_pitch += its.degrees * its.deviation * its.deviation * its.pitches;
                result.scatter.degrees += its.degrees;
              }
          }
      if (result.scatter.degrees > 0.)
        result.scatter.deviation = std::sqrt(of_pitch / result.scatter.degrees);
      results.push_back(result);
    }
  std::stable_sort(results.begin(), results.end(), [](const StudyResult &a, const StudyResult &b) {
    return a.share() < b.share();
  });
  return results;
}

std::string beyond(const Studies &studies, const std::map<std::string, double> &here)
{
  std::string text;
  for (const auto &[name, value] : here)
    {
      double least = std::numeric_limits<double>::infinity(), most = 0.;
      for (const auto &[study, groups] : studies.groups)
        if (const auto one = groups.find(name); one != groups.end())
          {
            least = std::min(least, one->second);
            most  = std::max(most, one->second);
          }
      // what is given with four digits
      if (most > 0. && !(value >= 0.999 * least && value <= 1.001 * most))
        text += (text.empty() ? "" : ", ") + name + " " + to_text(value, 3) + " here, " +
                to_text(least, 3) + " to " + to_text(most, 3) + " there";
    }
  return text;
}

double of_numerics(const Studies &studies, const std::string &output)
{
  double square = 0.;
  for (const StudyResult &result : studies.all)
    for (const auto &[study, variant] :
         {std::pair{"reduced", "exact-fine"}, {"reduced", "exact-200"}, {"step", "twelfth"}})
      if (result.study == study && result.variant == variant && result.output == output &&
          result.low * result.high > 0.)
        square += result.error * result.error;
  return std::sqrt(square);
}

double of_sampling(const Studies &studies, const std::string &output, const double interval)
{
  std::map<double, double> errors = {{0., 0.}}; // by interval
  const std::string        entry  = "Output/History interval in us=";
  for (const StudyResult &result : studies.all)
    if (result.study == "sampling" && result.output == output)
      for (const std::string &one : result.overrides)
        if (one.rfind(entry, 0) == 0)
          errors[1e-6 * std::stod(one.substr(entry.size()))] = std::abs(result.error);
  const auto after = errors.lower_bound(interval);
  if (after == errors.end()) // at least so much
    return errors.size() == 1 ? 0. : errors.rbegin()->second * interval / errors.rbegin()->first;
  if (after == errors.begin())
    return after->second;
  const auto   before = std::prev(after);
  const double part   = (interval - before->first) / (after->first - before->first);
  return before->second + part * (after->second - before->second);
}

StudyResult with_numerics(StudyResult result, const double numerics)
{
  if (numerics > 0.)
    {
      result.low  = result.error - std::hypot(result.error - result.low, numerics);
      result.high = result.error + std::hypot(result.high - result.error, numerics);
    }
  return result;
}
} // namespace chaindrive
