// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <sstream>

namespace chaindrive
{
std::string to_text(const double value, const int digits)
{
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

namespace
{
/// Levenshtein distance, one row of the table at a time.
std::size_t edit_distance(const std::string &a, const std::string &b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    {
      std::size_t diagonal = row[0];
      row[0]               = i + 1;
      for (std::size_t j = 0; j < b.size(); ++j)
        {
          const bool equal = std::tolower(static_cast<unsigned char>(a[i])) ==
                             std::tolower(static_cast<unsigned char>(b[j]));
          const std::size_t replaced = diagonal + (equal ? 0 : 1);
          diagonal                   = row[j + 1];
          row[j + 1]                 = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
  return row.back();
}
} // namespace

std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates)
{
  std::string nearest;
  std::size_t best = (name.size() + 1) / 2;
  for (const std::string &candidate : candidates)
    if (const std::size_t distance = edit_distance(name, candidate); distance < best)
      {
        best    = distance;
        nearest = candidate;
      }
  return nearest;
}
} // namespace chaindrive
