// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/functions/function.h>

#include <memory>
#include <string>

namespace chaindrive::functions
{
/// A Table through the points of a text file: on each line two numbers, the variable and the value,
/// apart by a comma, a semicolon or blanks. Empty lines and those that begin with # are left out,
/// and so is a first line that begins with a word, the titles of the columns. Values of the
/// variable are multiplied by @p x_unit, then @p x_zero is added; the others are multiplied by @p
/// y_unit. Lines may end as those of any system do.
///
/// InputError that names the file, the line and what is allowed: when it is no regular file, cannot
/// be read, is larger than 64 MB, has no points or more than a million, or a line has other than
/// two finite numbers or a variable that does not exceed the one before.
std::shared_ptr<const Table>
read_csv(const std::string &path, double x_unit = 1., double y_unit = 1., double x_zero = 0.);
} // namespace chaindrive::functions
