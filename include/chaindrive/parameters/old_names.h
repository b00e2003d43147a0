// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// What an entry of the .prm file was called in earlier versions.
struct OldEntry
{
  std::string old_path; ///< such as "Section/Old name"
  std::string path;     ///< of the entry as it is called now
};

/// What a value of a choice was called in earlier versions.
struct OldValue
{
  std::string path; ///< of the entry as it is called now
  std::string old_value, value;
};

/// The names that are still read, with a note that says what is called how now.
const std::vector<OldEntry> &old_entries();
const std::vector<OldValue> &old_values();

/// The present path of the entry that was called @p old_path; empty if none was.
std::string current_path(const std::string &old_path);

/// @p value of the entry @p path in present words: a loop of a study, {a | b}, word by word.
std::string current_value(const std::string &path, const std::string &value);
} // namespace chaindrive::parameters
