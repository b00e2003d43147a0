// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/reader.h>

#include <map>
#include <string>
#include <vector>

namespace chaindrive::model
{
/// parameters::read_parameters() of a file that is to be run: with the number of links and the
/// field interval where they are auto, and InputError for entries that contradict each other.
parameters::Input read_parameters(const std::string              &file,
                                  const std::vector<std::string> &overrides = {});

/// The same for entries at hand, as parameters::read_entries().
parameters::Input read_entries(const std::map<std::string, std::string> &values);
} // namespace chaindrive::model
