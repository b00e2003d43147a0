// SPDX-License-Identifier: LGPL-2.1-or-later
// Work in processes of its own: results in their order, never more at a time than asked for, ends
// of every kind; what lacked memory or died once more alone; a stop signal ends all at once.
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/processes.h>
#include <chaindrive/utilities/signals.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <thread>
#include <unistd.h>

namespace
{
using namespace chaindrive;
using namespace std::chrono_literals;
using End = WorkResult::End;

/// Known to all processes.
struct Shared
{
  std::atomic<int> at_work{0}, most{0}, tries[12] = {}, others_beside_second_try{0};
};

Shared *make_shared_memory()
{
  void *memory =
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : new (memory) Shared;
}

const char *name_of(const End end)
{
  switch (end)
    {
    case End::none:
      return "not done";
    case End::good:
      return "good";
    case End::input:
      return "input";
    case End::memory:
      return "memory";
    case End::exception:
      return "exception";
    case End::died:
      return "died";
    }
  return "?";
}

std::string work(Shared &shared, const std::size_t i)
{
  const int n = ++shared.at_work;
  for (int most = shared.most; n > most && !shared.most.compare_exchange_weak(most, n);)
    ;
  const int tries = ++shared.tries[i];
  if (tries > 1 && n > 1)
    ++shared.others_beside_second_try;
  std::this_thread::sleep_for(20ms * static_cast<int>(12 - i)); // the last is the first to end
  --shared.at_work;
  switch (i)
    {
    case 2:
      throw InputError("an entry");
    case 3:
      throw std::bad_alloc();
    case 5:
      throw std::runtime_error("a failure");
    case 6:
      ::raise(SIGKILL);
      break;
    case 7:
      ::_exit(9);
    case 8:
      if (tries == 1)
        ::raise(SIGSEGV);
      return "good alone";
    case 9:
      return std::string(10000000, 'x'); // does not fit into a pipe
    case 10:
      return {};
    default:
      break;
    }
  return "result " + std::to_string(i);
}
} // namespace

int main()
{
  Shared     &shared  = *make_shared_memory();
  std::size_t seen    = 0;
  const auto  results = do_in_processes(
      12, 3, [&](const std::size_t i) { return work(shared, i); }, [&](auto n) { seen = n; });
  for (std::size_t i = 0; i < results.size(); ++i)
    std::cout << i << ": " << name_of(results[i].end) << ", "
              << (results[i].text.size() > 100 ?
                      std::to_string(results[i].text.size()) + " letters" :
                      results[i].text)
              << ", tries " << shared.tries[i] << '\n';
  std::cout << "most at a time: " << shared.most << ", ended: " << seen
            << ", beside a second try: " << shared.others_beside_second_try << '\n'
            << "no work: " << do_in_processes(0, 3, nullptr, nullptr).size() << '\n';

  catch_stop_signals();
  const auto since   = std::chrono::steady_clock::now();
  const auto stopped = do_in_processes(
      5,
      2,
      [](const std::size_t i) {
        std::this_thread::sleep_for(i == 0 ? 0s : 60s);
        return std::string("done");
      },
      [](const auto n) {
        if (n == 1)
          ::raise(SIGTERM);
      });
  const bool soon = std::chrono::steady_clock::now() - since < 20s;
  std::cout << "stopped soon: " << (soon ? "yes" : "no") << ", first: " << stopped[0].text
            << ", last: " << name_of(stopped[4].end) << '\n';
}
