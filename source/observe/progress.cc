// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/system.h>
#include <chaindrive/observe/progress.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace chaindrive::observe
{
std::string duration_text(const double seconds)
{
  char            text[32];
  const long long s = std::llround(std::max(seconds, 0.));
  if (s < 60)
    std::snprintf(text, sizeof(text), "%lld s", s);
  else if (s < 3600)
    std::snprintf(text, sizeof(text), "%lld min %02lld s", s / 60, s % 60);
  else
    std::snprintf(text, sizeof(text), "%lld h %02lld min", s / 3600, s % 3600 / 60);
  return text;
}

namespace
{
constexpr int steps = 20; ///< lines in the log
}

bool Progress::console_is_terminal()
{
  for (const char *name :
       {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "SLURM_STEP_ID", "SLURM_STEPID"})
    if (std::getenv(name) != nullptr)
      return false;
  return ::isatty(STDOUT_FILENO) == 1;
}

Progress::Progress(files::Log &log, const double start, const double end, const bool terminal)
    : log_(log)
    , start_(start)
    , end_(end)
    , first_(start)
    , terminal_(terminal)
    , began_(Clock::now())
    , shown_(began_)
{
}

void Progress::observe(const dynamics::System &system,
                       const unsigned long,
                       const double,
                       dynamics::Services &)
{
  if (system.world.is_first_rank())
    update(system.world.time);
}

void Progress::serialize(const Archive &archive, const dynamics::System &system)
{
  if (!archive.reads())
    return;
  first_    = system.world.time;
  reported_ = static_cast<int>((first_ - start_) / (end_ - start_) * steps + 1e-9);
}

Progress::~Progress() { log_.show_status(""); }

void Progress::update(const double time)
{
  const double done = (time - start_) / (end_ - start_);
  const int    step = static_cast<int>(done * steps + 1e-9);
  const bool   line = step > reported_;
  if (!line && !terminal_)
    return;
  const auto now = Clock::now();
  using namespace std::chrono_literals;
  const bool rewrite = terminal_ && now - shown_ > 200ms;
  if (!line && !rewrite)
    return;

  const double now_done = (time - first_) / (end_ - first_);
  const double elapsed  = std::chrono::duration<double>(now - began_).count();
  char         text[160];
  std::snprintf(text,
                sizeof(text),
                "%3.0f %%  t = %.3f of %.3f ms  elapsed %s, left %s",
                std::floor(100. * done + 1e-7),
                1e3 * time,
                1e3 * end_,
                duration_text(elapsed).c_str(),
                now_done > 0. ? duration_text(elapsed * (1. - now_done) / now_done).c_str() : "?");
  if (line)
    {
      reported_ = step;
      if (terminal_)
        log_.write_to_file(text);
      else
        log_ << text << std::endl;
    }
  if (rewrite)
    {
      shown_ = now;
      log_.show_status(text);
    }
}
} // namespace chaindrive::observe
