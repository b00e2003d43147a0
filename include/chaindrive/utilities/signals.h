// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace chaindrive
{
/// Whether SIGHUP is ignored, as `nohup` asks for: to be called before libraries change it.
bool hang_up_is_ignored();

/// From now on SIGTERM, SIGINT, SIGUSR1, SIGHUP and SIGPIPE do not end the program at once but are
/// remembered. A second SIGTERM, SIGINT or SIGUSR1 more than two seconds after the first ends it as
/// usual. With @p ignore_hang_up nothing comes of SIGHUP.
void catch_stop_signals(bool ignore_hang_up = false);

/// The first of these signals that has come; 0: none.
int stop_signal();

/// The name of signal @p number, one of these.
std::string name_of_stop_signal(int number);
} // namespace chaindrive
