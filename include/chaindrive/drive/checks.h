// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/facts.h>

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// Something about a drive or its run that a designer would not leave so.
struct Check
{
  std::string name;     ///< in snake_case
  std::string sentence; ///< with the figures, and what to change
};

/// What is found, by rules of thumb that doc/theory.md lists.
std::vector<Check> check_design(const Parameters &parameters, const Facts &facts);

/// Member `checks` of summary.json: doc/output.md.
files::Json to_json(const std::vector<Check> &checks);
} // namespace chaindrive::drive
