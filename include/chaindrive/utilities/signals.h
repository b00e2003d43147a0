// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace chaindrive
{
/// From now on SIGTERM, SIGINT and SIGUSR1 do not end the program at once but are remembered; a
/// second one of the same kind ends it as usual.
void catch_stop_signals();

/// The signal that came since then; 0: none.
int stop_signal();

/// The name of signal @p number, one of these three.
std::string name_of_stop_signal(int number);
} // namespace chaindrive
