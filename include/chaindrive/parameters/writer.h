// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/declarations.h>

#include <iosfwd>
#include <map>
#include <string>

namespace chaindrive::parameters
{
/// Writes all entries of @p declarations as a .prm file: with the value in @p values, found by the
/// entry's path, or else with the default. @p documented puts meaning and allowed values above each
/// entry; otherwise changed entries have their default in a comment.
void write_prm(std::ostream                             &out,
               const Declarations                       &declarations,
               const std::map<std::string, std::string> &values,
               bool                                      documented);
} // namespace chaindrive::parameters
