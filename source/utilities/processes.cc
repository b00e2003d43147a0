// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/memory.h>
#include <chaindrive/utilities/processes.h>
#include <chaindrive/utilities/signals.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <numeric>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

namespace chaindrive
{
namespace
{
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;
using End = WorkResult::End;

constexpr auto grace = 2s; // between SIGTERM and SIGKILL

/// A process at work.
struct Worker
{
  std::size_t number; ///< of its work
  pid_t       process;
  int         pipe; ///< from which its result is read
  std::string said; ///< so far: a letter for the end, and the text
};

constexpr char letter_of(const End end) { return static_cast<char>('0' + static_cast<int>(end)); }

/// What this process is to say of its work.
std::string result_of(const std::function<std::string(std::size_t)> &work, const std::size_t number)
{
  try
    {
      return letter_of(End::good) + work(number);
    }
  catch (const InputError &error)
    {
      return letter_of(End::input) + std::string(error.what());
    }
  catch (const std::bad_alloc &)
    {
      return std::string(1, letter_of(End::memory));
    }
  catch (const std::exception &error)
    {
      return letter_of(End::exception) + std::string(error.what());
    }
}

/// From here on signals end this process as if nothing had been done about them; those that are
/// ignored stay so.
void end_by_signals()
{
  for (const int number : {SIGTERM, SIGINT, SIGUSR1, SIGHUP, SIGPIPE})
    {
      struct sigaction action = {};
      if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
        std::signal(number, SIG_DFL);
    }
}

/// The life of a copy: neither destructors nor what others have asked for at the end of the process
/// (MPI's, buffers of streams) are its business.
[[noreturn]] void live(const std::function<std::string(std::size_t)> &work,
                       const std::size_t                              number,
                       const int                                      pipe,
                       const pid_t                                    parent)
{
  end_by_signals();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent)
    ::_exit(1);
  const std::string text = result_of(work, number);
  for (std::size_t done = 0; done < text.size();)
    {
      const ssize_t n = ::write(pipe, text.data() + done, text.size() - done);
      if (n < 0 && errno != EINTR)
        ::_exit(1);
      done += static_cast<std::size_t>(std::max<ssize_t>(n, 0));
    }
  ::_exit(0);
}

class Workers
{
public:
  explicit Workers(const std::function<std::string(std::size_t)> &work) : work_(work) {}

  /// None is left behind, whatever happens.
  ~Workers()
  {
    for (const Worker &worker : at_work_)
      ::kill(worker.process, SIGKILL);
    for (const Worker &worker : at_work_)
      end(worker);
  }
  Workers(const Workers &)            = delete;
  Workers &operator=(const Workers &) = delete;

  std::size_t size() const { return at_work_.size(); }

  /// Whether there is a process more. When the system has none, others have to end first: RunError
  /// if there are no others.
  bool begin(const std::size_t number)
  {
    int         ends[2] = {-1, -1};
    const pid_t parent  = ::getpid();
    const bool  piped   = ::pipe(ends) == 0;
    remember_pages_of_files();
    const pid_t process = piped ? ::fork() : -1;
    if (process == 0)
      {
        ::close(ends[0]);
        for (const Worker &other : at_work_)
          ::close(other.pipe);
        live(work_, number, ends[1], parent);
      }
    const int error = errno;
    if (piped)
      ::close(ends[1]);
    if (process > 0)
      {
        at_work_.push_back({number, process, ends[0], {}});
        return true;
      }
    if (piped)
      ::close(ends[0]);
    if (at_work_.empty())
      throw RunError(std::string("No process can be started: ") + std::strerror(error) + ".");
    return false;
  }

  /// Waits up to a tenth of a second for what workers say, and puts what those have come to that
  /// have ended into @p results. Returns how many these are.
  std::size_t look(std::vector<WorkResult> &results)
  {
    std::vector<pollfd> pipes;
    for (const Worker &worker : at_work_)
      pipes.push_back({worker.pipe, POLLIN, 0});
    if (::poll(pipes.data(), pipes.size(), 100) <= 0)
      return 0;
    std::vector<Worker> left;
    for (std::size_t i = 0; i < pipes.size(); ++i)
      if (pipes[i].revents != 0 && !read(at_work_[i]))
        results[at_work_[i].number] = end(at_work_[i]);
      else
        left.push_back(std::move(at_work_[i]));
    const std::size_t n = at_work_.size() - left.size();
    at_work_            = std::move(left);
    return n;
  }

  void signal(const int number) const
  {
    for (const Worker &worker : at_work_)
      ::kill(worker.process, number);
  }

private:
  /// Takes what a worker says; false: it has said all.
  static bool read(Worker &worker)
  {
    char          part[65536];
    const ssize_t n = ::read(worker.pipe, part, sizeof(part));
    if (n > 0)
      worker.said.append(part, static_cast<std::size_t>(n));
    return n > 0 || (n < 0 && errno == EINTR);
  }

  static WorkResult end(const Worker &worker)
  {
    ::close(worker.pipe);
    int status = 0;
    while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR)
      ;
    if (WIFSIGNALED(status))
      return {End::died, "its process was ended by " + name_of_stop_signal(WTERMSIG(status))};
    if (status != 0 || worker.said.empty())
      return {End::died, "its process ended with status " + std::to_string(WEXITSTATUS(status))};
    return {static_cast<End>(worker.said[0] - '0'), worker.said.substr(1)};
  }

  const std::function<std::string(std::size_t)> &work_;
  std::vector<Worker>                            at_work_;
};

bool lacked_something(const WorkResult &result)
{
  return result.end == End::memory || result.end == End::died;
}
} // namespace

std::vector<WorkResult> do_in_processes(const std::size_t                              n,
                                        const unsigned int                             at_a_time,
                                        const std::function<std::string(std::size_t)> &work,
                                        const std::function<void(std::size_t)>        &look)
{
  std::vector<WorkResult>  results(n);
  Workers                  workers(work);
  std::vector<std::size_t> next(n);
  std::iota(next.rbegin(), next.rend(), 0); // the first is at the end
  std::size_t done   = 0;
  const auto  do_all = [&](const unsigned int most) {
    while ((!next.empty() || workers.size() > 0) && stop_signal() == 0)
      {
        while (!next.empty() && workers.size() < most && workers.begin(next.back()))
          next.pop_back();
        done += workers.look(results);
        look(done);
      }
  };
  do_all(std::max(1U, at_a_time));
  for (std::size_t i = n; i-- > 0;)
    if (at_a_time > 1 && lacked_something(results[i]))
      next.push_back(i);
  done -= next.size();
  do_all(1);

  workers.signal(SIGTERM);
  for (const auto since = Clock::now(); workers.size() > 0 && Clock::now() - since < grace;)
    workers.look(results);
  return results;
}
} // namespace chaindrive
