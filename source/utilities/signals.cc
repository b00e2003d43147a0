// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/signals.h>

#include <csignal>
#include <initializer_list>

namespace chaindrive
{
namespace
{
volatile std::sig_atomic_t came = 0;
}

void catch_stop_signals()
{
  came                    = 0;
  struct sigaction action = {};
  action.sa_handler       = [](const int number) { came = number; };
  action.sa_flags         = static_cast<int>(SA_RESTART | SA_RESETHAND);
  for (const int number : {SIGTERM, SIGINT, SIGUSR1})
    sigaction(number, &action, nullptr);
}

int stop_signal() { return came; }

std::string name_of_stop_signal(const int number)
{
  return number == SIGTERM ? "SIGTERM" : number == SIGINT ? "SIGINT" : "SIGUSR1";
}
} // namespace chaindrive
