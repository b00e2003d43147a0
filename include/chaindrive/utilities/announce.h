// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

namespace chaindrive
{
/// Takes a sentence on what begins now and takes seconds, for who waits for it. Empty: nobody does.
using Announce = std::function<void(const std::string &)>;
} // namespace chaindrive
