// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace chaindrive
{
/// The program's version, set in the top-level CMakeLists.txt.
extern const char *const version;
} // namespace chaindrive
