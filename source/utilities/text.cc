// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
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
/// @p value, or the number of so many digits next to it in the direction of @p sign.
std::string rounded(const double value, const int digits, const double sign)
{
  std::string  text = to_text(value, digits);
  const double read = std::strtod(text.c_str(), nullptr);
  if (!std::isfinite(value) || sign * (read - value) >= 0.)
    return text;
  const double unit = std::pow(10., std::floor(std::log10(std::abs(value))) + 1. - digits);
  return to_text(read + sign * unit, digits);
}
} // namespace

std::string to_text_at_least(const double value, const int digits)
{
  return rounded(value, digits, 1.);
}

std::string to_text_at_most(const double value, const int digits)
{
  return rounded(value, digits, -1.);
}

std::string in_mm(const double length, const int digits)
{
  return to_text(length * 1e3, digits) + " mm";
}

std::string join(const std::vector<std::string> &words, const std::string &separator)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : separator) + words[i];
  return text;
}

namespace
{
/// Whether two letters are the same, upper and lower case counted as equal.
bool same_letter(const unsigned char a, const unsigned char b)
{
  return std::tolower(a) == std::tolower(b);
}

/// Levenshtein distance in which two neighbours exchanged are one edit, a row of the table at a
/// time.
std::size_t edit_distance(const std::string &a, const std::string &b)
{
  std::vector<std::size_t> row(b.size() + 1), above, two_above;
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    {
      two_above = above;
      above     = row;
      row[0]    = i + 1;
      for (std::size_t j = 0; j < b.size(); ++j)
        {
          row[j + 1] = std::min(
              {above[j] + (same_letter(a[i], b[j]) ? 0 : 1), row[j] + 1, above[j + 1] + 1});
          if (i > 0 && j > 0 && same_letter(a[i], b[j - 1]) && same_letter(a[i - 1], b[j]))
            row[j + 1] = std::min(row[j + 1], two_above[j - 1] + 1);
        }
    }
  return row.back();
}
} // namespace

std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates)
{
  std::string nearest;
  std::size_t best = (name.size() + 1) / 4 + 1;
  for (const std::string &candidate : candidates)
    if (const std::size_t distance = edit_distance(name, candidate); distance < best)
      {
        best    = distance;
        nearest = candidate;
      }
    else if (distance == best && candidate != nearest)
      nearest.clear(); // either may be meant
  return nearest;
}

std::vector<std::string> names_begun_with(const std::string              &name,
                                          const std::vector<std::string> &candidates)
{
  std::vector<std::string> begun;
  for (const std::string &candidate : candidates)
    if (!name.empty() && candidate.size() > name.size() &&
        std::equal(name.begin(), name.end(), candidate.begin(), same_letter) &&
        (candidate[name.size()] == ' ' || candidate[name.size()] == '_'))
      begun.push_back(candidate);
  return begun;
}
} // namespace chaindrive
