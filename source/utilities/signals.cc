// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/signals.h>

#include <array>
#include <csignal>
#include <ctime>
#include <utility>

namespace chaindrive
{
namespace
{
// A batch system signals every process of a job, and mpirun passes its own on: what comes together
// is one request. A terminal that goes away may signal twice, seconds apart: it never ends a run.
constexpr std::time_t one_request = 2; // s

volatile std::sig_atomic_t came = 0;
volatile std::time_t       since;

std::time_t now()
{
  timespec time = {};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec;
}

void remember(const int number)
{
  if (came == 0)
    {
      since = now();
      came  = number;
    }
  else if (number == came && number != SIGHUP && number != SIGPIPE && now() - since > one_request)
    {
      std::signal(number, SIG_DFL);
      std::raise(number); // delivered when this function returns
    }
}

constexpr std::array<std::pair<int, const char *>, 5> names{{{SIGTERM, "SIGTERM"},
                                                             {SIGINT, "SIGINT"},
                                                             {SIGUSR1, "SIGUSR1"},
                                                             {SIGHUP, "SIGHUP"},
                                                             {SIGPIPE, "SIGPIPE"}}};
} // namespace

bool hang_up_is_ignored()
{
  struct sigaction action = {};
  return sigaction(SIGHUP, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void catch_stop_signals(const bool ignore_hang_up)
{
  for (const auto &signal : names)
    {
      struct sigaction action = {};
      action.sa_handler       = signal.first == SIGHUP && ignore_hang_up ? SIG_IGN : remember;
      action.sa_flags         = SA_RESTART;
      sigaction(signal.first, &action, nullptr);
    }
}

int stop_signal() { return came; }

std::string name_of_stop_signal(const int number)
{
  for (const auto &signal : names)
    if (signal.first == number)
      return signal.second;
  return "signal " + std::to_string(number);
}
} // namespace chaindrive
