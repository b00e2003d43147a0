// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/model/arriving_joints.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace chaindrive::model
{
namespace
{
using dealii::numbers::PI;

constexpr int margin = 2; // links beside those that arrive: plates on both sides pull at a joint

} // namespace

std::vector<char> elastic_joints(const Parameters         &parameters,
                                 const drive::Drive       &drive,
                                 const Effects            &effects,
                                 std::vector<std::string> &notes)
{
  const int n = static_cast<int>(drive.layout.joints.size());
  if (parameters.model.elastic_links == parameters::ElasticLinks::all ||
      !parameters.model.capabilities().is_elastic)
    return std::vector<char>(n, true);

  // joint 0 sits where the chain comes in; with every pitch that the driver turns joint n-1, n-2,
  // ... comes after it
  const auto turned = [&drive, start = parameters.time.start](const double time) {
    return drive.driver().program.speed->integral(start, std::max(time, start));
  };
  const double per_angle = drive.driver().form.teeth / (2. * PI);
  const double from      = parameters.output.window_start.value(),
               to        = parameters.output.window_end.value_or(parameters.time.end);
  int first              = n - static_cast<int>(std::ceil(per_angle * turned(to))) - margin;
  int last               = n - static_cast<int>(std::floor(per_angle * turned(from))) + margin;
  // inner links, which begin at even joints, are the outermost: their bushes are whole
  first -= (first % 2 + 2) % 2;
  last += 1 - (last % 2 + 2) % 2;
  if (last - first + 1 >= n)
    throw InputError("Model/Elastic links = region of interest: about " +
                     std::to_string(last - first + 1 - 2 * margin) +
                     " rollers arrive at the driver in Output's window, with those beside them the "
                     "whole chain of " +
                     std::to_string(n) + "; choose a shorter window or Elastic links = all.");

  std::vector<char> elastic(n, false);
  for (int k = first; k <= last; ++k)
    elastic[((k % n) + n) % n] = true;
  const auto name = [n](const int k) { return std::to_string(((k % n) + n) % n); };
  notes.push_back(
      "Elastic: rollers " + name(first) + " to " + name(last) + ", " +
      std::to_string(last - first + 1) + " of " + std::to_string(n) +
      ", and the links between them: they arrive at the driver in Output's "
      "window, or up to " +
      std::to_string(margin) + " links before and after; all else is " +
      (effects.is_on(Effect::reduced_bodies) ? text_of(parameters.model.other_links) : "rigid"));
  return elastic;
}
} // namespace chaindrive::model
