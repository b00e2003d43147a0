// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/version.h>

namespace chaindrive
{
const char *const version = CHAINDRIVE_VERSION;
} // namespace chaindrive
