// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/plugin.h>

// What this shared library is. What it adds stands in the other sources, each of which registers
// itself.

CHAINDRIVE_PLUGIN("example", "1.0")
