// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/checkpoints.h>
#include <chaindrive/observe/recorder.h>
#include <chaindrive/observe/summary.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/signals.h>
#include <chaindrive/utilities/text.h>

#include <filesystem>
#include <utility>

namespace chaindrive::observe
{
using dynamics::Request;

namespace
{
constexpr unsigned int n_kept = 2;

constexpr const char *name_of_system = "system";

double seconds_since(const std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
} // namespace

Checkpoints::Checkpoints(const parameters::Time           &time,
                         const parameters::Output         &output,
                         std::string                       directory,
                         std::string                       fixed,
                         const unsigned long               n_steps,
                         const double                      dt,
                         std::vector<dynamics::Observer *> observers,
                         files::Log                       &log)
    : time_(time)
    , output_(output)
    , directory_(std::move(directory))
    , fixed_(std::move(fixed))
    , n_steps_(n_steps)
    , dt_(dt)
    , observers_(std::move(observers))
    , log_(log)
    , schedule_(time.start, output.checkpoint_interval)
    , began_(Clock::now())
    , written_(began_)
{
}

void Checkpoints::observe(const dynamics::System &system,
                          const unsigned long     step,
                          const double,
                          dynamics::Services &services)
{
  const bool stopped = services.asked(Request::stop);
  const bool due     = schedule_.due(system.world.time);
  const bool ended   = step == n_steps_ && (output_.checkpoint_interval > 0. ||
                                          !last_.empty()); // who wants more time can go on
  if (step > 0 && (due || ended || stopped || services.asked(Request::checkpoint)))
    write(system, step, services);
  if (stopped && step < n_steps_)
    {
      say_why(system.world.time);
      services.stop_run();
      return;
    }
  ask(system.world, services);
}

void Checkpoints::ask(const World &world, dynamics::Services &services) const
{
  if (stop_signal() != 0)
    services.ask(Request::stop);
  if (!world.is_first_rank())
    return;
  if (past_wall_clock_limit())
    services.ask(Request::stop);
  if (output_.checkpoint_wait > 0. && seconds_since(written_) > output_.checkpoint_wait)
    services.ask(Request::checkpoint);
}

bool Checkpoints::past_wall_clock_limit() const
{
  const double limit = output_.wall_clock_limit;
  return limit > 0. && seconds_since(began_) > limit;
}

void Checkpoints::say_why(const double time)
{
  const int number = stop_signal();
  log_ << "Stopped by "
       << (number != 0             ? name_of_stop_signal(number) :
           past_wall_clock_limit() ? "Output/Wall-clock limit in s" :
                                     "a signal to another rank")
       << " at " << to_text(time * 1e3) << " ms." << last()
       << " To go on, start it again as before with --resume auto." << std::endl;
}

void Checkpoints::serialize(const Archive &archive, const dynamics::System &system)
{
  schedule_.serialize(archive, system.world.time);
}

void Checkpoints::serialize_observers(const Archive          &archive,
                                      const dynamics::System &system,
                                      PhaseTimer             &timer)
{
  for (dynamics::Observer *observer : observers_)
    observer->serialize(archive / observer->name(), system);
  serialize(archive / name(), system);

  std::vector<double> cpu_seconds;
  for (const auto &row : rows_of_all_ranks(timer, system.world.communicator()))
    cpu_seconds.push_back(row.cpu_seconds);
  double elapsed = timer.elapsed();
  archive("cpu seconds", cpu_seconds);
  archive("elapsed", elapsed);
  if (archive.reads() && system.world.is_first_rank())
    timer.go_on_from(cpu_seconds, elapsed);
}

void Checkpoints::write(const dynamics::System &system,
                        const unsigned long     step,
                        dynamics::Services     &services)
{
  PhaseTimer             &timer = services.timer();
  const PhaseTimer::Scope scope(timer, timer.add("Output"));
  files::CheckpointItems  items(system.world.communicator());
  services.write_state(items.archive() / name_of_system);
  serialize_observers(items.archive(), system, timer);
  const std::string path = files::checkpoint_path(directory_, step);
  items.write(path, {step, system.world.time, dt_}, fixed_);
  last_    = path; // not before it is there
  written_ = Clock::now();
  if (!system.world.is_first_rank())
    return;
  log_.write_to_file("Checkpoint at " + to_text(system.world.time * 1e3) + " ms: " + last_);
  auto found = files::checkpoints_in(directory_);
  for (; found.size() > n_kept; found.erase(found.begin()))
    {
      std::error_code error; // one too many does no harm
      std::filesystem::remove(found.begin()->second, error);
    }
}

unsigned long Checkpoints::resume(dynamics::System &system, const files::CheckpointFile &file)
{
  MPI_Barrier(system.world.communicator()); // all ranks have looked at what is now changed
  const unsigned long step = file.header().step;
  if (step > n_steps_)
    throw InputError("The checkpoint '" + file.path() + "' is at " +
                     to_text(file.header().time * 1e3) +
                     " ms, after Time/End time in ms = " + to_text(time_.end * 1e3) + ".");
  try
    {
      system.serialize(file.archive() / name_of_system);
      serialize_observers(file.archive(), system, system.timer);
    }
  catch (const InputError &error)
    {
      throw InputError("The checkpoint '" + file.path() + "' cannot be used: " + error.what() +
                       ".");
    }
  if (system.world.is_first_rank())
    for (const auto &[later, path] : files::checkpoints_in(directory_))
      if (later > step)
        std::filesystem::remove(path);
  last_ = file.path();
  return step;
}

std::string Checkpoints::last() const
{
  return last_.empty() ? "" : " The last checkpoint is '" + last_ + "'.";
}

std::string Checkpoints::last_valid(const double time) const
{
  if (last_.empty())
    return " There is no checkpoint to go on from.";
  std::string found;
  for (const auto &[step, path] : files::checkpoints_in(directory_))
    if (time_.start + step * dt_ <= time)
      found = path;
  return found.empty() ? " No checkpoint is from before that." :
                         " The checkpoint '" + found + "' is good: --resume goes on from it.";
}

namespace
{
/// InputError when the histories that @p file counts on are missing or damaged.
void check_histories(const files::CheckpointFile &file, const std::string &directory)
{
  try
    {
      Recorder::check(file.archive() / "recorder", directory);
    }
  catch (const InputError &error)
    {
      throw InputError("The checkpoint '" + file.path() + "' cannot be used: " + error.what() +
                       ".");
    }
}

/// The newest checkpoint that is whole and whose histories are.
std::unique_ptr<files::CheckpointFile> newest(const std::string &directory, files::Log &log)
{
  std::string problem;
  const auto  present = files::checkpoints_in(directory);
  for (auto file = present.rbegin(); file != present.rend(); ++file)
    try
      {
        auto found = std::make_unique<files::CheckpointFile>(file->second);
        check_histories(*found, directory);
        if (!problem.empty())
          log.warn(problem + " The one before it is taken.");
        return found;
      }
    catch (const InputError &error)
      {
        problem += (problem.empty() ? "" : "\n") + std::string(error.what());
      }
  if (!problem.empty())
    throw InputError(problem + "\nNo other checkpoint is in '" + directory +
                     "'. Without --resume the run begins anew and replaces its results.");
  log << "There is no checkpoint in '" << directory << "': the run begins at its beginning.\n";
  return nullptr;
}

/// The path of the checkpoint @p named: a path, or the name of one in the output @p directory.
std::string path_of(const std::string &named, const std::string &directory)
{
  const std::filesystem::path path(named), there = directory / path;
  std::error_code             error;
  return path.has_parent_path() || exists(path, error) || !exists(there, error) ? named :
                                                                                  there.string();
}
} // namespace

std::unique_ptr<files::CheckpointFile> find_checkpoint(const std::string &resume,
                                                       const std::string &directory,
                                                       const std::string &fixed,
                                                       files::Log        &log)
{
  if (resume.empty())
    return nullptr;
  std::unique_ptr<files::CheckpointFile> file;
  if (resume == "auto")
    file = newest(directory, log);
  else
    {
      namespace fs           = std::filesystem;
      const std::string path = path_of(resume, directory);
      file                   = std::make_unique<files::CheckpointFile>(path);
      std::error_code error;
      if (!fs::equivalent(fs::absolute(path).parent_path(), directory, error))
        throw InputError("The checkpoint '" + path + "' does not lie in the output directory '" +
                         directory + "', where its histories are; choose --output.");
      check_histories(*file, directory);
    }
  if (file != nullptr)
    {
      file->check_parameters(fixed);
      log << "Resumed from '" << file->path() << "' at " << to_text(file->header().time * 1e3)
          << " ms.\n";
    }
  return file;
}
} // namespace chaindrive::observe
