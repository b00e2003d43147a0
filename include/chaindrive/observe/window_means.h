// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/json.h>
#include <chaindrive/observe/observation.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/statistics.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::observe
{
/// What the summary says of numbers over the window of the averages (Window): their means. The
/// value at the end of a step stands for the whole step.
class WindowMeans
{
public:
  /// Of the numbers called @p names, for the run that @p now observes, which must outlive this.
  WindowMeans(const Observation &now, std::initializer_list<std::string> names);

  /// Their @p values at the end of a step, in the order of their names.
  void add(std::initializer_list<double> values);

  /// Adds `NAME_mean` for each.
  void summarize(files::Json &summary) const;

  /// InputError when the run that goes on has another window, as far as the run has gone.
  void serialize(const Archive &archive);

private:
  const Observation                              &now_;
  std::vector<std::pair<std::string, WindowMean>> means_;
};
} // namespace chaindrive::observe
