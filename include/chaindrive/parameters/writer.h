// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/declarations.h>

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// Closes the sections in @p open that @p section does not lie in, and opens those that are
/// missing.
void change_section(std::ostream &out, std::vector<std::string> &open, const std::string &section);

/// Writes all entries of @p declarations as a .prm file: with the value in @p values, found by the
/// entry's path, or else with the default. @p documented puts meaning and allowed values above each
/// entry; otherwise changed entries have their default in a comment.
void write_prm(std::ostream                             &out,
               const Declarations                       &declarations,
               const std::map<std::string, std::string> &values,
               bool                                      documented);
} // namespace chaindrive::parameters
