// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace chaindrive::files
{
/// The folder @p name of what belongs to the program beside itself, such as "scripts": in
/// share/chaindrive beside the folder of an installed program, wherever that was moved to, else in
/// the sources from which it was built. InputError when it is in neither.
std::string data_folder(const std::string &name);
} // namespace chaindrive::files
