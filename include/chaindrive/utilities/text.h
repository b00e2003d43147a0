// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace chaindrive
{
/// @p value with at most @p digits significant digits and no trailing zeros, for messages and logs.
std::string to_text(double value, int digits = 6);

/// The same for a limit that someone may copy: what is written is on the side of @p value that is
/// allowed, so at least, or at most, @p value.
std::string to_text_at_least(double value, int digits = 6);
std::string to_text_at_most(double value, int digits = 6);

/// @p length [m] with its unit: "12.7 mm".
std::string in_mm(double length, int digits = 7);

/// The @p words one after the other, @p separator between them.
std::string join(const std::vector<std::string> &words, const std::string &separator = ", ");

/// The member of @p candidates with the smallest edit distance to @p name, upper and lower case
/// counted as equal and two letters exchanged as one edit; empty when it takes more than one edit
/// for four letters of @p name: a suggestion that means something else does harm. Nor is
/// one of several returned that are equally near.
std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates);

/// The members of @p candidates of which @p name is the beginning, up to a blank or an underscore,
/// upper and lower case counted as equal; none of an empty name.
std::vector<std::string> names_begun_with(const std::string              &name,
                                          const std::vector<std::string> &candidates);
} // namespace chaindrive
