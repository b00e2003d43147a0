// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/console.h>
#include <chaindrive/files/sink.h>
#include <chaindrive/utilities/signals.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <poll.h>
#include <string>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace chaindrive::files
{
namespace
{
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::chrono::milliseconds patience_after_signal = 2s;

std::atomic<bool> output_refused = false; ///< see Console::output_was_refused()

/// What the program and the thread that writes share; the last of them frees it.
struct Shared
{
  std::mutex              mutex;
  std::condition_variable changed;
  std::string             waiting;         ///< not yet taken by the system
  Clock::time_point       last_taken;      ///< when something was
  bool                    refused = false; ///< the reader is gone: nothing is written any more
  bool                    no_more = false; ///< the program will not write any more

  bool done() const { return waiting.empty() || refused; }
};

/// Hands over what waits, until there will be no more. Small pieces, so that it is seen how far the
/// reader is.
void hand_over(const int descriptor, const std::shared_ptr<Shared> &shared)
{
  constexpr std::size_t        piece = 512;
  std::unique_lock<std::mutex> lock(shared->mutex);
  while (true)
    {
      shared->changed.wait(lock, [&] { return shared->no_more || !shared->done(); });
      if (shared->done())
        break;
      const std::string text = shared->waiting.substr(0, piece);
      lock.unlock();
      ssize_t n = ::write(descriptor, text.data(), text.size());
      if (n < 0 && errno == EAGAIN) // others may have made the descriptor so
        {
          pollfd room = {descriptor, POLLOUT, 0};
          ::poll(&room, 1, 100);
          n = 0;
        }
      else if (n < 0 && errno == EINTR)
        n = 0;
      lock.lock();
      if (n < 0)
        {
          shared->refused = true;
          output_refused  = output_refused || descriptor == STDOUT_FILENO;
        }
      else
        shared->waiting.erase(0, static_cast<std::size_t>(n));
      if (n > 0)
        shared->last_taken = Clock::now();
      shared->changed.notify_all();
    }
  shared->changed.notify_all();
}
} // namespace

class Console::Queue : public Sink
{
public:
  explicit Queue(const int descriptor) : descriptor_(descriptor) {}

  ~Queue() override
  {
    std::unique_lock<std::mutex> lock(shared_->mutex);
    shared_->last_taken = std::max(shared_->last_taken, Clock::now());
    while (!shared_->done())
      {
        shared_->changed.wait_for(lock, 50ms);
        const auto limit =
            stop_signal() == 0 ? patience_ : std::min(patience_, patience_after_signal);
        if (Clock::now() - shared_->last_taken > limit)
          break;
      }
    const bool all   = shared_->done();
    shared_->no_more = true;
    shared_->changed.notify_all();
    lock.unlock();
    if (!thread_.joinable())
      return;
    if (all)
      thread_.join();
    else
      thread_.detach(); // it ends with the process
  }

  void give_up_after(const std::chrono::milliseconds patience) { patience_ = patience; }

  bool is_behind() const
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    return !shared_->done();
  }

protected:
  std::streamsize xsputn(const char *text, const std::streamsize n) override
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    if (shared_->refused)
      return n;
    if (shared_->waiting.empty())
      shared_->last_taken = Clock::now();
    shared_->waiting.append(text, static_cast<std::size_t>(n));
    if (!thread_.joinable() && !alone_)
      start();
    if (alone_)
      hand_over_here();
    shared_->changed.notify_all();
    return n;
  }

private:
  /// Signals are for the program's own thread; of a reader that is gone, write() tells this one.
  void start()
  {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    try
      {
        thread_ = std::thread(hand_over, descriptor_, shared_);
      }
    catch (const std::system_error &) // no room for a thread: the program waits for the reader
      {
        alone_ = true;
      }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  /// Hands over what waits without a thread, while the reader takes something now and then.
  void hand_over_here()
  {
    std::string &waiting = shared_->waiting;
    while (!waiting.empty() && Clock::now() - shared_->last_taken <= std::min(patience_, longest))
      {
        pollfd        room = {descriptor_, POLLOUT, 0};
        const ssize_t n =
            ::poll(&room, 1, 100) > 0 ?
                ::write(descriptor_, waiting.data(), std::min<std::size_t>(waiting.size(), 512)) :
                0;
        if (n < 0 && errno != EAGAIN && errno != EINTR)
          {
            output_refused = output_refused || descriptor_ == STDOUT_FILENO;
            break;
          }
        if (n > 0)
          {
            waiting.erase(0, static_cast<std::size_t>(n));
            shared_->last_taken = Clock::now();
          }
      }
    shared_->refused = !waiting.empty();
  }

  static constexpr std::chrono::milliseconds longest = 10s; ///< without a thread

  int                       descriptor_;
  bool                      alone_    = false; ///< without a thread
  std::chrono::milliseconds patience_ = std::chrono::hours(24 * 365 * 100);
  std::shared_ptr<Shared>   shared_   = std::make_shared<Shared>();
  std::thread               thread_;
};

Console::Console(const int descriptor)
    : std::ostream(nullptr), queue_(std::make_unique<Queue>(descriptor))
{
  rdbuf(queue_.get());
}

Console::~Console() = default;

void Console::give_up_after(const std::chrono::milliseconds patience)
{
  queue_->give_up_after(patience);
}

bool Console::is_behind() const { return queue_->is_behind(); }

bool Console::output_was_refused() { return output_refused; }
} // namespace chaindrive::files
