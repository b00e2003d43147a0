// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/command_line.h>
#include <chaindrive/commands.h>
#include <chaindrive/files/console.h>
#include <chaindrive/model/needs.h>
#include <chaindrive/observe/schema.h>
#include <chaindrive/packages.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/plugins.h>
#include <chaindrive/serve.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/signals.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <poll.h>
#include <string>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace
{
using namespace chaindrive;

/// Whether SIGHUP was ignored when the program was started, as by nohup. UCX, which comes with
/// OpenMPI 5, takes that signal for itself when it is loaded, before main() begins: this is asked
/// before any library is.
bool hang_up_was_ignored = false;
void look_at_hang_up() { hang_up_was_ignored = hang_up_is_ignored(); }
__attribute__((section(".preinit_array"), used)) void (*before_libraries)() = look_at_hang_up;

/// What main() is to become when all is done; no words: nothing.
struct Successor
{
  std::vector<std::string> words;
  std::string              needs;      ///< said when it cannot be started
  int                      status = 3; ///< then
};

/// Whether a pipe that this process writes to has no reader any more, as of "... | head".
bool nobody_reads()
{
  pollfd output{STDOUT_FILENO, 0, 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

constexpr const char *unwritten = "Standard output could not be written.";

/// To be called after a command whose answer stands on standard output alone: RunError if it does
/// not, although there is a reader.
void check_output()
{
  if (files::Console::output_was_refused() && !nobody_reads())
    throw RunError(unwritten);
}

/// Does what the command line asks for; returns the status.
int run(const int argc, char **argv, const bool is_first_rank, Successor &successor)
{
  const CommandLine command_line = parse_command_line(argc, argv);
  load_plugins(command_line.plugins, MPI_COMM_WORLD);
  switch (command_line.command)
    {
    case Command::run:
      {
        const auto directory = run_command(command_line, MPI_COMM_WORLD);
        if (directory && command_line.report && !command_line.quiet && is_first_rank)
          successor = {report_after_run(*directory), packages_of_reports(), 0};
        return directory ? 0 : 4;
      }
    case Command::plan:
      if (!plan_command(command_line, MPI_COMM_WORLD))
        return 4;
      check_output();
      break;
    case Command::parts:
      parts_command(command_line, MPI_COMM_WORLD);
      check_output();
      break;
    case Command::noise:
      if (is_first_rank)
        noise_command(command_line);
      break;
    case Command::study:
      successor = {study_command(command_line, MPI_COMM_WORLD), packages_of_studies()};
      if (command_line.dry_run)
        check_output();
      return stop_signal() == 0 ? 0 : 4;
    case Command::calibrate:
      successor = {calibrate_command(command_line, MPI_COMM_WORLD), packages_of_studies()};
      if (command_line.dry_run)
        check_output();
      return stop_signal() == 0 ? 0 : 4;
    case Command::report:
      successor = {report_command(command_line, MPI_COMM_WORLD), packages_of_reports()};
      break;
    case Command::export_files:
      successor = {export_command(command_line, MPI_COMM_WORLD), packages_of_exports()};
      break;
    case Command::select:
      if (is_first_rank)
        select_command(command_line, std::cout);
      break;
    case Command::sprocket:
      if (is_first_rank)
        sprocket_command(command_line, std::cout);
      break;
    case Command::template_file:
      if (is_first_rank)
        template_command(command_line, std::cout);
      break;
    case Command::document:
      if (is_first_rank)
        std::cout << (command_line.man                 ? man_page() :
                      command_line.schema              ? observe::schema().dump(1) + "\n" :
                      !command_line.completion.empty() ? bash_completion() :
                                                         parameters::parameter_documentation() +
                                                             model::documentation_of_needs());
      break;
    case Command::serve: // before anything is started that copies cannot share: main()
      break;
    case Command::version:
      if (is_first_rank)
        std::cout << version_text();
      break;
    case Command::help:
      if (is_first_rank)
        std::cout << help_text();
    }
  return 0;
}

/// How a rank's part ended. Status: 0 done, 2 input that cannot be run, 3 a run that failed, 4 a
/// run that was stopped and can be resumed.
struct End
{
  int         status = 0;
  std::string message;
};

End run_and_catch(const int argc, char **argv, const bool is_first_rank, Successor &successor)
{
  try
    {
      return {run(argc, argv, is_first_rank, successor), {}};
    }
  catch (const InputError &error)
    {
      return {2, error.what()};
    }
  catch (const std::bad_alloc &)
    {
      return {3,
              "There is not enough memory for what was asked for: choose coarser meshes, fewer "
              "links, a longer Output/History interval in us, or more ranks."};
    }
  catch (const std::exception &error)
    {
      return {3, error.what()};
    }
}

/// What has become of a server: the command line of a copy, or the status of the server.
struct Served
{
  std::optional<std::vector<std::string>> words;
  int                                     status = 0;
};

Served serve_and_catch(const int argc, char **argv)
{
  try
    {
      return {serve(parse_command_line(argc, argv).parameter_file)};
    }
  catch (const std::exception &error)
    {
      std::cerr << "chaindrive: " << error.what() << std::endl;
      return {{}, dynamic_cast<const InputError *>(&error) != nullptr ? 2 : 3};
    }
}

/// Waits for all ranks, without burning the processor, and returns the largest status of any. A
/// rank that failed alone does not wait for long: it ends the others, which wait for it somewhere.
int end_together(const End &end, const bool is_first_rank, const MPI_Comm comm)
{
  using namespace std::chrono_literals;
  const auto say = [&end] {
    files::Console err(STDERR_FILENO);
    err.give_up_after(2s); // a reader who reads no more must not keep the program
    err << "chaindrive: " << end.message << std::endl;
  };
  if (!end.message.empty() && is_first_rank)
    say();

  const auto  since = std::chrono::steady_clock::now();
  MPI_Request request;
  MPI_Ibarrier(comm, &request);
  int done = 0;
  for (MPI_Test(&request, &done, MPI_STATUS_IGNORE); !done;
       MPI_Test(&request, &done, MPI_STATUS_IGNORE))
    {
      if (!end.message.empty() && std::chrono::steady_clock::now() - since > 5s)
        {
          if (!is_first_rank)
            say();
          MPI_Abort(comm, end.status);
        }
      std::this_thread::sleep_for(5ms);
    }
  return dealii::Utilities::MPI::max(end.status, comm);
}

/// Writes what is left for standard output; returns the status, of a failed run if that fails.
/// PETSc would report at length that it cannot when it ends.
int end_output(const int status)
{
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout)
    return status;
  const bool had_enough = nobody_reads();
  if (std::freopen("/dev/null", "w", stdout) == nullptr || had_enough)
    return status;
  std::cerr << "chaindrive: " << unwritten << std::endl;
  return std::max(status, 3);
}

/// What this process was started with, "name=value".
std::vector<std::string> environment_variables()
{
  std::vector<std::string> all;
  for (char **variable = environ; *variable != nullptr; ++variable)
    all.emplace_back(*variable);
  return all;
}

/// To C: the texts, and a null pointer.
std::vector<char *> pointers_to(std::vector<std::string> &texts)
{
  std::vector<char *> all;
  all.reserve(texts.size() + 1);
  for (std::string &text : texts)
    all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// Gives this process to @p command, in the environment that it was started in: MPI_Init() leaves
/// variables behind that let mpirun crash. Returns the status when that fails.
int become(Successor command, std::vector<std::string> environment)
{
  std::cout.flush();
  ::execvpe(command.words.front().c_str(),
            pointers_to(command.words).data(),
            pointers_to(environment).data());
  std::cerr << "chaindrive: " << command.words.front()
            << " cannot be started: " << std::strerror(errno) << ". " << command.needs << std::endl;
  return command.status;
}
} // namespace

int main(int argc, char **argv)
{
  std::vector<std::string> words; // of a copy that a server has made
  std::vector<char *>      pointers;
  if (argc > 1 && std::string(argv[1]) == "serve")
    {
      const Served served = serve_and_catch(argc, argv);
      if (!served.words)
        return served.status;
      words    = *served.words;
      pointers = pointers_to(words);
      argc     = static_cast<int>(words.size());
      argv     = pointers.data();
    }
  // MPI and PETSc would end in a core dump
  if (std::error_code error; std::filesystem::current_path(error).empty())
    {
      std::cerr << "chaindrive: The working directory cannot be used: " << error.message()
                << ". It may have been removed; change to another one." << std::endl;
      return 2;
    }
  // A program that was not started by mpirun needs no daemon to talk to other ranks: without it
  // OpenMPI starts a second earlier. Nor does it need OpenMPI's directory in /tmp, which all such
  // programs would share: one that ends takes it away from one that begins.
  const std::vector<std::string> environment = environment_variables();
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
    {
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
      // Below Slurm's srun, without one of its services for MPI, OpenMPI 4 takes the program for a
      // rank that was launched by that service, does not find it and aborts. PMI-2 is a service
      // that not every OpenMPI knows: one that is alone needs none.
      const auto  is_there = [](const char *name) { return std::getenv(name) != nullptr; };
      const char *tasks    = std::getenv("SLURM_STEP_NUM_TASKS");
      const bool  pmi      = (is_there("PMI_RANK") || is_there("PMI_FD")) &&
                       (tasks == nullptr || std::string(tasks) != "1");
      if (!pmi && !is_there("PMIX_RANK") && !is_there("PMIX_NAMESPACE"))
        {
          unsetenv("SLURM_STEP_ID");
          // Nor does it need a network. OpenMPI would look for one, which with libfabric means
          // reading the kernel's list of symbols twice, and a second of waiting at the end. What a
          // user has chosen for mpirun holds for ranks that talk to each other.
          setenv("OMPI_MCA_pml", "ob1", 1);
          setenv("OMPI_MCA_btl", "self", 1);
          // Nor to know which caches its cores share: looking at the machine, and for graphics
          // processors by plug-ins, takes half of the time that MPI takes to start.
          setenv("HWLOC_COMPONENTS", "no_os,stop", 0);
          setenv("HWLOC_PLUGINS_PATH", "", 0);
        }
    }
  // Ranks of one machine need no network either, which the default looks for.
  else if (const char *local = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
           local != nullptr && std::string(local) == std::getenv("OMPI_COMM_WORLD_SIZE"))
    {
      setenv("OMPI_MCA_pml", "ob1", 0);
      // What a step exchanges, some 30 KiB, is copied through shared memory at once: the other
      // way, for which a system call fetches it when both are ready, takes twice as long.
      setenv("OMPI_MCA_btl_vader_eager_limit", "131072", 0);
    }
  std::signal(SIGXFSZ, SIG_IGN); // a file at its size limit is a failed write, told in a sentence
  catch_stop_signals(hang_up_was_ignored);
  Successor successor;
  int       status = 0;
  {
    // its name alone: PETSc, which deal.II hands the words on to, would say that it knows none of
    // ours
    int                                            n_words = std::min(argc, 1);
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(n_words, argv, 1);
    catch_stop_signals(
        hang_up_was_ignored); // again: PETSc, which deal.II starts, catches some itself

    const bool is_first_rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    status                   = end_together(
        run_and_catch(argc, argv, is_first_rank, successor), is_first_rank, MPI_COMM_WORLD);
    status = end_output(status);
  }
  if (successor.words.empty())
    return status;
  return become(successor, environment);
}
