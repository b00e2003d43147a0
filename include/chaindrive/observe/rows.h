// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/family.h>
#include <chaindrive/observe/quantity.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace chaindrive::observe
{
/// Labels of columns: these numbers.
inline std::vector<std::string> labels_of(const std::vector<unsigned int> &numbers)
{
  std::vector<std::string> labels;
  labels.reserve(numbers.size());
  for (const unsigned int k : numbers)
    labels.push_back(std::to_string(k));
  return labels;
}

/// Labels of columns: 0 to @p n - 1.
inline std::vector<std::string> labels_up_to(const unsigned int n)
{
  std::vector<std::string> labels;
  labels.reserve(n);
  for (unsigned int k = 0; k < n; ++k)
    labels.push_back(std::to_string(k));
  return labels;
}

/// Fills a row with @p values, which must outlive the channel.
inline Channels::Fill copy_of(const std::vector<double> &values)
{
  return
      [&values](const Channels::Row row) { std::copy(values.begin(), values.end(), row.begin()); };
}

/// Fills a row with the smallest gap [m] of each joint in @p families, which must outlive the
/// channel; not a number where none is within reach.
template <typename FamilyType>
Channels::Fill smallest_gaps_of(const std::vector<const FamilyType *> &families)
{
  return [&families](const Channels::Row row) {
    for (const FamilyType *family : families)
      for (const contact::Record &record : family->records())
        if (record.gap < std::numeric_limits<double>::max())
          row[record.joint] = std::fmin(row[record.joint], record.gap); // ignores NaN
  };
}

/// Whether @p families have elastic surfaces.
template <typename FamilyType>
bool know_pressure(const std::vector<const FamilyType *> &families)
{
  return std::any_of(families.begin(), families.end(), [](const FamilyType *family) {
    return family->knows_pressure();
  });
}

/// Makes @p largest the largest pressure [Pa] of each joint in @p families, and at a sample in the
/// window raises @p most [Pa], not a number at first, to the largest of them. Nothing without
/// elastic surfaces. To be called by all ranks.
template <typename FamilyType>
void find_pressures(const Observation                     &now,
                    const std::vector<const FamilyType *> &families,
                    std::vector<double>                   &largest,
                    double                                &most)
{
  if (!know_pressure(families))
    return;
  std::fill(largest.begin(), largest.end(), 0.);
  auto of_family = now.pressures().begin();
  for (const contact::Family *family : now.system.contacts.families())
    {
      if (std::find(families.begin(), families.end(), family) != families.end())
        for (std::size_t k = 0; k < of_family->size(); ++k)
          largest[k] = std::max(largest[k], (*of_family)[k]);
      ++of_family;
    }
  if (now.time() >= now.window().start() && now.time() <= now.window().end())
    for (const double pressure : largest)
      most = std::fmax(most, pressure); // ignores NaN
}
} // namespace chaindrive::observe
