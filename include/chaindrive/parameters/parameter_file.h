// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// One statement of a .prm file: comments and surrounding blanks removed, continued lines joined.
struct Line
{
  unsigned int number; ///< of its first line in the file, from 1
  std::string  text;
};

/// Contents of the .prm file @p file. Throws InputError when it is missing, is no regular file,
/// cannot be read, is far too large, or holds bytes that do not occur in text.
std::string read_text(const std::string &file);

/// The statements of a .prm file with contents @p text.
std::vector<Line> statements(const std::string &text);
} // namespace chaindrive::parameters
