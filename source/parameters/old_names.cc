// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/old_names.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace chaindrive::parameters
{
const std::vector<OldEntry> &old_entries()
{
  static const std::vector<OldEntry> all = {
      {"Model/Half model", "Model/Symmetry model"},
      {"Elements/Column mass scaling", "Elements/Selective mass scaling"},
      {"Time/Step in us", "Time/Time step in us"}};
  return all;
}

const std::vector<OldValue> &old_values()
{
  static const std::vector<OldValue> all = {
      {"Model/Elastic links", "arriving", "region of interest"},
      {"Elements/Plates", "brick", "solid"},
      {"Elements/Plates", "shell", "solid-shell"},
      {"Elements/Bushes", "brick", "solid"},
      {"Elements/Bushes", "shell", "solid-shell"}};
  return all;
}

std::string current_path(const std::string &old_path)
{
  for (const OldEntry &entry : old_entries())
    if (entry.old_path == old_path)
      return entry.path;
  return "";
}

std::string current_value(const std::string &path, const std::string &value)
{
  std::string result = value;
  for (const OldValue &one : old_values())
    if (one.path == path)
      for (std::size_t begin = 0; begin <= result.size();)
        {
          const std::size_t end   = std::min(result.find_first_of("{|}", begin), result.size());
          const std::string piece = result.substr(begin, end - begin);
          std::string       now   = piece;
          if (dealii::Utilities::trim(piece) == one.old_value)
            now.replace(piece.find(one.old_value), one.old_value.size(), one.value);
          result.replace(begin, piece.size(), now);
          begin += now.size() + 1;
        }
  return result;
}
} // namespace chaindrive::parameters
