// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace chaindrive::files
{
/// Keeps its members in the order in which they were added.
using Json = nlohmann::ordered_json;

/// Writes @p content to @p path all at once: a reader finds the old file or the new one, never a
/// part. Numbers keep all their digits; what is not a finite number becomes null. RunError when it
/// cannot be written.
void write_json(const std::string &path, const Json &content);
} // namespace chaindrive::files
